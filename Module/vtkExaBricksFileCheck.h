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
 * Three kinds are checked, without reading values, so that it takes little time:
 *
 * - AMReX plotfiles: that counts, levels, boxes, widths and refinement ratios fit together, and
 *   that the data of each box lie in a file that is long enough;
 * - Enzo's .hierarchy: that grids, the pointers between them, their edges and the parameters fit
 *   together, and that the HDF5 files beside it are whole and hold a group for each grid, with data
 *   sets of its size;
 * - VTK's .vthb and .vth: that levels, boxes, spacings and refinement ratios fit together, and that
 *   the .vti file of each block has that place and size, and data of that length for each array.
 *
 * Not found are changed values, nor what makes another data set that is whole: a .vthb without its
 * last block. Of other kinds of files nothing is known, and no fault found. VTK's Enzo reader finds
 * no data beside a .hierarchy in the current folder, unless its path has a folder in it.
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

  /// Whether files of this kind are checked: folders with a file "Header", which are AMReX
  /// plotfiles, and files whose names end in .hierarchy, .vthb or .vth.
  static bool CanCheck(const std::string& path);
  /// What is wrong with it: what was expected, and what was found where. Empty: nothing was found.
  /// Begins with "of a kind that is not read", where it may be whole, but is 2-D, not Cartesian or
  /// of another version.
  static std::string FindFault(const std::string& path);

protected:
  vtkExaBricksFileCheck() = default;
  ~vtkExaBricksFileCheck() override = default;

private:
  vtkExaBricksFileCheck(const vtkExaBricksFileCheck&) = delete;
  void operator=(const vtkExaBricksFileCheck&) = delete;
};

#endif
