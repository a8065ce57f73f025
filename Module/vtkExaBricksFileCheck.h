// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExaBricksFileCheck
 * @brief   whether an AMR file is what its headers say, before a reader trusts them
 *
 * VTK's readers of AMR files believe what headers say of counts, boxes and places in files: of
 * damaged ones some crash, or read other values without a word. Ask here first:
 *
 * @code
 * const std::string fault = vtkExaBricksFileCheck::FindFault("plt00216");
 * if (!fault.empty()) { std::cerr << "plt00216 is damaged: " << fault << "\n"; }
 * @endcode
 *
 * AMReX plotfiles are checked: that counts, levels, boxes, widths and refinement ratios fit
 * together, and that the data of each box lie in a file that is long enough. Values are not read,
 * so that it takes little time. Of other kinds of files nothing is known, and no fault found.
 */
#ifndef vtkExaBricksFileCheck_h
#define vtkExaBricksFileCheck_h

#include "vtkObject.h"
#include "vtkRenderingVolumeExaBricksModule.h" // for the export macro

#include <string> // for paths and faults

class VTKRENDERINGVOLUMEEXABRICKS_EXPORT vtkExaBricksFileCheck : public vtkObject
{
public:
  static vtkExaBricksFileCheck* New();
  vtkTypeMacro(vtkExaBricksFileCheck, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Whether files of this kind are checked: folders with a file "Header", AMReX plotfiles.
  static bool CanCheck(const std::string& path);
  /// What is wrong with it: what was expected, and what was found where. Empty: nothing was found.
  static std::string FindFault(const std::string& path);

protected:
  vtkExaBricksFileCheck() = default;
  ~vtkExaBricksFileCheck() override = default;

private:
  vtkExaBricksFileCheck(const vtkExaBricksFileCheck&) = delete;
  void operator=(const vtkExaBricksFileCheck&) = delete;
};

#endif
