// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMExaBricksExportProxy
 * @brief   says that an exporter leaves out the volumes of a vtkExaBricksRepresentation
 *
 * ParaView's exporters of scenes write surfaces, and pass over volumes in silence. This is a
 * sub-proxy that Exporters.xml adds to them; it watches the vtkExporter of the exporter that it
 * belongs to.
 *
 * @sa
 * vtkExaBricksRepresentation
 */
#ifndef vtkSMExaBricksExportProxy_h
#define vtkSMExaBricksExportProxy_h

#include "vtkParaViewExaBricksModule.h" // for the export macro
#include "vtkSMProxy.h"
#include "vtkWeakPointer.h" // for vtkWeakPointer

class vtkRenderWindow;

class VTKPARAVIEWEXABRICKS_EXPORT vtkSMExaBricksExportProxy : public vtkSMProxy
{
public:
  static vtkSMExaBricksExportProxy* New();
  vtkTypeMacro(vtkSMExaBricksExportProxy, vtkSMProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMExaBricksExportProxy();
  ~vtkSMExaBricksExportProxy() override;

  void CreateVTKObjects() override;

private:
  vtkSMExaBricksExportProxy(const vtkSMExaBricksExportProxy&) = delete;
  void operator=(const vtkSMExaBricksExportProxy&) = delete;

  void WatchExporter();
  void ExporterModified(vtkObject* caller, unsigned long event, void* data);

  vtkWeakPointer<vtkObject> Exporter;     // the one that is watched
  vtkWeakPointer<vtkRenderWindow> Window; // the one that it writes at this moment
};

#endif
