// SPDX-License-Identifier: BSD-3-Clause
// Four floats or integers in one register. Where the compiler has no such types, GLM's.
#ifndef ExaBricksBenchmarksNativeVector_h
#define ExaBricksBenchmarksNativeVector_h

#include <cstring>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#ifdef __SSE4_1__
#include <immintrin.h>
#endif

namespace exabricks
{
namespace benchmarks
{
namespace native
{
#ifdef __SSE4_1__
using Vec4 = float __attribute__((vector_size(16)));
using IVec4 = int __attribute__((vector_size(16)));

inline Vec4 broadcast(float x) { return _mm_set1_ps(x); }
inline Vec4 min(Vec4 a, Vec4 b) { return _mm_min_ps(a, b); }
inline Vec4 max(Vec4 a, Vec4 b) { return _mm_max_ps(a, b); }
inline Vec4 abs(Vec4 a) { return _mm_andnot_ps(_mm_set1_ps(-0.0f), a); }
inline Vec4 toFloat(IVec4 a) { return _mm_cvtepi32_ps((__m128i)a); }
inline IVec4 toInteger(Vec4 a) { return (IVec4)_mm_cvttps_epi32(a); }
inline Vec4 swapHalves(Vec4 a) { return _mm_movehl_ps(a, a); }
// a[0], a[1], b[0], b[1]
inline Vec4 loadPairs(const float* a, const float* b)
{
  const __m128i lower = _mm_loadu_si64(a);
  return _mm_castsi128_ps(_mm_unpacklo_epi64(lower, _mm_loadu_si64(b)));
}
#else
using Vec4 = glm::vec4;
using IVec4 = glm::ivec4;

inline Vec4 broadcast(float x) { return Vec4(x); }
inline Vec4 min(Vec4 a, Vec4 b) { return glm::min(a, b); }
inline Vec4 max(Vec4 a, Vec4 b) { return glm::max(a, b); }
inline Vec4 abs(Vec4 a) { return glm::abs(a); }
inline Vec4 toFloat(IVec4 a) { return Vec4(a); }
inline IVec4 toInteger(Vec4 a) { return IVec4(a); }
inline Vec4 swapHalves(Vec4 a) { return { a[2], a[3], a[0], a[1] }; }
inline Vec4 loadPairs(const float* a, const float* b) { return { a[0], a[1], b[0], b[1] }; }
#endif

template <typename Vector, typename From>
Vector load(const From& from)
{
  static_assert(sizeof(Vector) == sizeof(From), "four of the same");
  Vector to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

inline Vec4 clamp(Vec4 a, Vec4 low, Vec4 high) { return min(max(a, low), high); }
inline Vec4 mix(Vec4 a, Vec4 b, float share) { return a + (b - a) * share; }
}
}
}

#endif
