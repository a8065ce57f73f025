// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMExaBricksRepresentationProxy
 * @brief   the client's side of a vtkExaBricksRepresentation
 *
 * Asks for the statistics after each picture: ParaView asks for values of information when a panel
 * is made. Hides properties of the panel that mean nothing to ExaBricks, and says so where one of
 * them is set. Keeps the opacity unit distance at about the length of a cell when more levels are
 * read, until somebody chooses another. Warns of what several ranks draw otherwise than one.
 *
 * @sa
 * vtkExaBricksStatistics
 */
#ifndef vtkSMExaBricksRepresentationProxy_h
#define vtkSMExaBricksRepresentationProxy_h

#include "vtkParaViewExaBricksModule.h" // for the export macro
#include "vtkSMRepresentationProxy.h"
#include "vtkWeakPointer.h" // for vtkWeakPointer

#include <memory> // for std::unique_ptr

class VTKPARAVIEWEXABRICKS_EXPORT vtkSMExaBricksRepresentationProxy
  : public vtkSMRepresentationProxy
{
public:
  static vtkSMExaBricksRepresentationProxy* New();
  vtkTypeMacro(vtkSMExaBricksRepresentationProxy, vtkSMRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ViewUpdated(vtkSMProxy* view) override;

protected:
  vtkSMExaBricksRepresentationProxy();
  ~vtkSMExaBricksRepresentationProxy() override;

  void CreateVTKObjects() override;

private:
  vtkSMExaBricksRepresentationProxy(const vtkSMExaBricksRepresentationProxy&) = delete;
  void operator=(const vtkSMExaBricksRepresentationProxy&) = delete;

  void UpdateStatistics();
  void UpdateUnitDistance(vtkSMProxy* view);
  void WarnOfUnusedSettings();
  void WarnOfRanks();

  vtkWeakPointer<vtkSMProxy> View; // that it was last in

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
