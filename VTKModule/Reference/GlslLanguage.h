// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of GLSL that the shared files in Shaders/ use, for C++ and any floating-point type.
#ifndef TetMarchReferenceGlslLanguage_h
#define TetMarchReferenceGlslLanguage_h

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tetmarch
{
namespace glsl
{

template <typename T>
struct Vec2
{
  T x, y;
  Vec2() = default;
  Vec2(T x_, T y_)
    : x(x_)
    , y(y_)
  {
  }
};

template <typename T>
struct Vec3
{
  T x, y, z;
  Vec3() = default;
  Vec3(T x_, T y_, T z_)
    : x(x_)
    , y(y_)
    , z(z_)
  {
  }
};

template <typename T>
struct Vec4
{
  T x, y, z, w;
  Vec4() = default;
  Vec4(T x_, T y_, T z_, T w_)
    : x(x_)
    , y(y_)
    , z(z_)
    , w(w_)
  {
  }
  template <typename U>
  explicit Vec4(const Vec4<U>& v)
    : x(T(v.x))
    , y(T(v.y))
    , z(T(v.z))
    , w(T(v.w))
  {
  }
};

template <typename T>
Vec2<T> operator*(Vec2<T> a, T s)
{
  return { a.x * s, a.y * s };
}
template <typename T>
Vec3<T> operator+(Vec3<T> a, Vec3<T> b)
{
  return { a.x + b.x, a.y + b.y, a.z + b.z };
}
template <typename T>
Vec3<T> operator-(Vec3<T> a, Vec3<T> b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z };
}
template <typename T>
Vec3<T> operator*(Vec3<T> a, Vec3<T> b)
{
  return { a.x * b.x, a.y * b.y, a.z * b.z };
}
template <typename T>
Vec3<T> operator*(Vec3<T> a, T s)
{
  return { a.x * s, a.y * s, a.z * s };
}
template <typename T>
Vec4<T> operator+(Vec4<T> a, Vec4<T> b)
{
  return { a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w };
}
template <typename T>
Vec4<T> operator-(Vec4<T> a, Vec4<T> b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w };
}
template <typename T>
Vec4<T> operator*(Vec4<T> a, Vec4<T> b)
{
  return { a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w };
}
template <typename T>
Vec4<T> operator*(Vec4<T> a, T s)
{
  return { a.x * s, a.y * s, a.z * s, a.w * s };
}

template <typename T>
T min(T a, T b)
{
  return std::min(a, b);
}
template <typename T>
T max(T a, T b)
{
  return std::max(a, b);
}
template <typename T>
T clamp(T a, T low, T high)
{
  return std::min(std::max(a, low), high);
}
using std::abs;
using std::cos;
using std::exp;
using std::floor;
using std::fma;
using std::log;
using std::pow;
using std::sin;
using std::sqrt;

template <typename T>
T dot(Vec3<T> a, Vec3<T> b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename T>
Vec3<T> cross(Vec3<T> a, Vec3<T> b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}
template <typename T>
Vec3<T> normalize(Vec3<T> a)
{
  return a * (T(1) / std::sqrt(dot(a, a)));
}

} // namespace glsl
} // namespace tetmarch

#endif
