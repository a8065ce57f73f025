// SPDX-License-Identifier: BSD-3-Clause
// Volumes of boxes on the lattice: with 2^31 half cells along each axis they need 93 bits.
#ifndef ExaBricksCoreLatticeVolume_h
#define ExaBricksCoreLatticeVolume_h

#include <cstdint>
#include <type_traits>

namespace exabricks
{
/// An unsigned integer of 128 bits.
class LatticeVolume
{
public:
  constexpr LatticeVolume() = default;
  constexpr explicit LatticeVolume(std::uint64_t volume)
    : Low(volume)
  {
  }
  /// Of a box with these sides, none longer than 2^31.
  constexpr LatticeVolume(std::uint64_t x, std::uint64_t y, std::uint64_t z)
  {
    const std::uint64_t area = x * y;
    const std::uint64_t lower = (area & 0xffffffffu) * z;
    const std::uint64_t upper = (area >> 32) * z; // in units of 2^32
    this->Low = lower + (upper << 32);
    this->High = (upper >> 32) + (this->Low < lower ? 1 : 0);
  }

  constexpr LatticeVolume& operator+=(const LatticeVolume& other)
  {
    this->Low += other.Low;
    this->High += other.High + (this->Low < other.Low ? 1 : 0);
    return *this;
  }
  constexpr bool operator==(const LatticeVolume& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
  constexpr bool operator!=(const LatticeVolume& other) const { return !(*this == other); }
  constexpr bool operator<(const LatticeVolume& other) const
  {
    return this->High < other.High || (this->High == other.High && this->Low < other.Low);
  }

  /// Whether the volume is 0.
  constexpr bool empty() const { return this->Low == 0 && this->High == 0; }

  /// Its lowest bits, for volumes that are known to fit, such as those of boxes in memory.
  template <typename Integer, typename = std::enable_if_t<std::is_integral_v<Integer>>>
  constexpr explicit operator Integer() const
  {
    return static_cast<Integer>(this->Low);
  }

private:
  std::uint64_t Low = 0;
  std::uint64_t High = 0; // in units of 2^64
};
}

#endif
