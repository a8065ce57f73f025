// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExaBricksStatistics
 * @brief   what a vtkExaBricksRepresentation drew last, in words
 *
 * An object of its own, as it exists where things are drawn alone: asked for a value of the
 * representation, which is on the client too, ParaView takes the client's.
 */
#ifndef vtkExaBricksStatistics_h
#define vtkExaBricksStatistics_h

#include "vtkObject.h"
#include "vtkParaViewExaBricksModule.h" // for the export macro

#include <string> // for std::string

class VTKPARAVIEWEXABRICKS_EXPORT vtkExaBricksStatistics : public vtkObject
{
public:
  static vtkExaBricksStatistics* New();
  vtkTypeMacro(vtkExaBricksStatistics, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkSetMacro(Text, std::string);
  /**
   * Levels, leaf cells, bricks, regions and how many of them show anything, device, its memory, and
   * seconds for a picture; "nothing drawn" if that is so.
   */
  const char* GetText() { return this->Text.c_str(); }

protected:
  vtkExaBricksStatistics() = default;
  ~vtkExaBricksStatistics() override = default;

  std::string Text = "nothing drawn";

private:
  vtkExaBricksStatistics(const vtkExaBricksStatistics&) = delete;
  void operator=(const vtkExaBricksStatistics&) = delete;
};

#endif
