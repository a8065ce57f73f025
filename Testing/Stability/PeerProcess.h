// SPDX-License-Identifier: BSD-3-Clause
// VTK's own ways to draw a setting, each in a process of its own: they may crash or never end.
#ifndef ExaBricksStabilityPeerProcess_h
#define ExaBricksStabilityPeerProcess_h

#include "Case.h"

namespace exabricks
{
namespace stability
{
struct Peer
{
  std::string name;   // on the command line
  std::string header; // in the log
};

/// Those that this VTK has.
std::vector<Peer> listPeers();

struct PeerResult
{
  std::string failure; // "crash", "timeout", "error", or empty
  reference::Image picture;
};

/// Runs this program (`self`) as `self --peer <name> <case> <file>`, at most a minute long. It
/// writes to `folder`, what it says to peers.log there.
PeerResult runPeer(const std::string& self, const Peer& peer, const std::string& caseName,
  const std::string& folder);

/// What the process does: draws in a window, and writes the picture to `file`.
void drawAsPeer(const std::string& peer, const Setting& setting, const std::string& file);
}
}

#endif
