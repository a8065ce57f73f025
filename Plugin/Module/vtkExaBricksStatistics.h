// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExaBricksStatistics
 * @brief   what a vtkExaBricksRepresentation drew last, in words
 *
 * It is an object of its own, which exists only where things are drawn: ParaView takes values of
 * the representation from the client, where it exists too, and nothing is drawn.
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
   * Levels, leaf cells, bricks, regions and how many of them show anything, the device, how much of
   * its memory is taken, and seconds for a picture; or "nothing drawn".
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
