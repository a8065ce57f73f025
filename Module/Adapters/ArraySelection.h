// SPDX-License-Identifier: BSD-3-Clause
// Which array of the input a volume mapper is to draw.
#ifndef ExaBricksAdaptersArraySelection_h
#define ExaBricksAdaptersArraySelection_h

#include <string>

class vtkAbstractVolumeMapper;
class vtkAlgorithm;

namespace exabricks
{
/// Selects as input array 0 of `filter` what the mapper's scalar mode and array name or id mean;
/// modifies it if that is another array than before. Returns an empty string, or why it cannot.
std::string selectArray(vtkAlgorithm* filter, vtkAbstractVolumeMapper* mapper);
}

#endif
