// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMExaBricksRepresentationProxy
 * @brief   asks for the statistics of a vtkExaBricksRepresentation after each picture
 *
 * ParaView asks for values of information when a panel is made; these change with each picture.
 *
 * @sa
 * vtkExaBricksStatistics
 */
#ifndef vtkSMExaBricksRepresentationProxy_h
#define vtkSMExaBricksRepresentationProxy_h

#include "vtkParaViewExaBricksModule.h" // for the export macro
#include "vtkSMRepresentationProxy.h"
#include "vtkWeakPointer.h" // for vtkWeakPointer

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

private:
  vtkSMExaBricksRepresentationProxy(const vtkSMExaBricksRepresentationProxy&) = delete;
  void operator=(const vtkSMExaBricksRepresentationProxy&) = delete;

  void UpdateStatistics();

  vtkWeakPointer<vtkSMProxy> View; // that it was last in
};

#endif
