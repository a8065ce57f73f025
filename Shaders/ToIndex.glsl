// SPDX-License-Identifier: BSD-3-Clause
// Whole numbers in [0, 2^23), without the conversion that saturates: slow on processors.
uint toIndex(float whole) { return floatBitsToUint(whole + 8388608.0) & 0x7fffffu; }
uvec3 toIndex(vec3 whole) { return floatBitsToUint(whole + 8388608.0) & 0x7fffffu; }
