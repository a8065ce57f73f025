// SPDX-License-Identifier: BSD-3-Clause

#include "Annotation.h"

#include "vtkCubeAxesActor.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkScalarsToColors.h"
#include "vtkTextProperty.h"

namespace render
{

namespace
{

// Black or white, whichever shows on the background.
double contrastOf(vtkRenderer* renderer)
{
  const double* background = renderer->GetBackground();
  return 0.3 * background[0] + 0.6 * background[1] + 0.1 * background[2] < 0.5 ? 1.0 : 0.0;
}

void setUp(vtkTextProperty* text, double gray)
{
  text->SetColor(gray, gray, gray);
  text->ItalicOff();
  text->BoldOff();
  text->ShadowOff();
}

}

void annotate(vtkRenderer* renderer, const double bounds[6], vtkScalarsToColors* colors,
  const std::string& title)
{
  const double gray = contrastOf(renderer);
  vtkNew<vtkCubeAxesActor> axes;
  axes->SetBounds(const_cast<double*>(bounds));
  axes->SetCamera(renderer->GetActiveCamera());
  axes->SetFlyModeToOuterEdges();
  axes->SetXTitle("x");
  axes->SetYTitle("y");
  axes->SetZTitle("z");
  for (int axis = 0; axis < 3; ++axis)
  {
    setUp(axes->GetTitleTextProperty(axis), gray);
    setUp(axes->GetLabelTextProperty(axis), gray);
  }
  for (vtkProperty* lines :
    { axes->GetXAxesLinesProperty(), axes->GetYAxesLinesProperty(), axes->GetZAxesLinesProperty() })
  {
    lines->SetColor(gray, gray, gray);
  }
  renderer->AddActor(axes);

  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(colors);
  bar->SetTitle(title.c_str());
  bar->SetNumberOfLabels(5);
  bar->UnconstrainedFontSizeOn();
  bar->SetBarRatio(0.25);
  bar->SetPosition(0.88, 0.1);
  bar->SetWidth(0.1);
  bar->SetHeight(0.8);
  for (vtkTextProperty* text : { bar->GetTitleTextProperty(), bar->GetLabelTextProperty() })
  {
    setUp(text, gray);
    text->SetFontSize(13);
  }
  renderer->AddViewProp(bar);
}

}
