// SPDX-License-Identifier: BSD-3-Clause
#include "Adapters/Processes.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"

#include <algorithm>

namespace exabricks
{
namespace
{
constexpr int ValuesTag = 28471;
constexpr vtkIdType LongestMessage = 1 << 28; // bytes

// The partner of a process in a round in which each has at most one: by the circle method of
// tournaments. Itself: it has none.
int partnerIn(int round, int rank, int ranks)
{
  const int even = ranks + ranks % 2;
  const int last = even - 1;
  int partner = rank == last ? round : (2 * round - rank % last + 2 * last) % last;
  partner = rank != last && partner == rank ? last : partner;
  return partner < ranks ? partner : rank;
}

void send(vtkMultiProcessController* controller, const std::vector<unsigned char>& bytes, int to)
{
  const auto size = static_cast<vtkIdType>(bytes.size());
  for (vtkIdType sent = 0; sent < size; sent += LongestMessage)
  {
    controller->Send(bytes.data() + sent, std::min(LongestMessage, size - sent), to, ValuesTag);
  }
}

void receive(vtkMultiProcessController* controller, std::vector<unsigned char>& bytes, int from)
{
  const auto size = static_cast<vtkIdType>(bytes.size());
  for (vtkIdType there = 0; there < size; there += LongestMessage)
  {
    controller->Receive(
      bytes.data() + there, std::min(LongestMessage, size - there), from, ValuesTag);
  }
}

}

Processes::Processes(vtkMultiProcessController* ofController)
  : controller(ofController)
  , rank(ofController->GetLocalProcessId())
  , count(ofController->GetNumberOfProcesses())
{
}

std::string Processes::agree(const std::string& fault) const
{
  const int failed = fault.empty() ? this->count : this->rank;
  int first = failed;
  this->controller->AllReduce(&failed, &first, 1, vtkCommunicator::MIN_OP);
  if (first == this->count)
  {
    return {};
  }
  std::string text = fault;
  vtkMultiProcessStream stream;
  if (first == this->rank)
  {
    stream << text;
  }
  this->controller->Broadcast(stream, first);
  if (first != this->rank)
  {
    stream >> text;
  }
  return "process " + std::to_string(first) + " of " + std::to_string(this->count) + ": " + text;
}

void Processes::exchange(std::vector<std::vector<unsigned char>>& sent,
  std::vector<std::vector<unsigned char>>& received) const
{
  const auto own = static_cast<std::size_t>(this->rank);
  received[own] = std::move(sent[own]);
  const int rounds = this->count + this->count % 2 - 1;
  for (int round = 0; round < rounds; ++round)
  {
    const int partner = partnerIn(round, this->rank, this->count);
    if (partner == this->rank)
    {
      continue;
    }
    auto& going = sent[static_cast<std::size_t>(partner)];
    auto& coming = received[static_cast<std::size_t>(partner)];
    if (this->rank < partner)
    {
      send(this->controller, going, partner);
      receive(this->controller, coming, partner);
    }
    else
    {
      receive(this->controller, coming, partner);
      send(this->controller, going, partner);
    }
    std::vector<unsigned char>().swap(going);
  }
}
}
