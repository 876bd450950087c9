// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/CurvedDeparture.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

constexpr double WithinTetrahedra = 3.0 / 2.0;
constexpr double WithinFaces = 4.0 / 3.0;
// The corners of each face, and its edges.
constexpr int CornersOfFaces[4][3] = { { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 3 }, { 0, 1, 2 } };
constexpr int EdgesOfFaces[4][3] = { { 3, 4, 5 }, { 1, 2, 5 }, { 0, 2, 4 }, { 0, 1, 3 } };

using Corners = std::array<Vector3, 4>;

// The gradients of the barycentric coordinates of the corners but the first one, times the
// determinant of the edges from that.
std::array<Vector3, 3> scaledGradients(const Corners& at)
{
  const Vector3 a = at[1] - at[0];
  const Vector3 b = at[2] - at[0];
  const Vector3 c = at[3] - at[0];
  return { { cross(b, c), cross(c, a), cross(a, b) } };
}

// Of the scalar beside that of the tetrahedron, continued to the same place.
double departureOfValues(const Corners& at, const std::array<double, 4>& values,
  const std::array<std::uint32_t, 6>& edges, const EdgeDepartures& departures,
  std::size_t component)
{
  const std::array<Vector3, 3> gradients = scaledGradients(at);
  const double determinant = dot(at[1] - at[0], gradients[0]);
  Vector3 gradient{};
  for (int k = 0; k < 3 && determinant != 0; ++k)
  {
    add((values[k + 1] - values[0]) / determinant, gradients[k], gradient);
  }
  double greatest = 0;
  for (const std::uint32_t edge : edges)
  {
    greatest = std::max(greatest,
      std::abs(departures.value(edge, component) - dot(gradient, departures.apart(edge))));
  }
  return WithinTetrahedra * greatest;
}

double departureOfFace(const Corners& at, int face, const std::array<std::uint32_t, 6>& edges,
  const EdgeDepartures& departures)
{
  const int* corners = CornersOfFaces[face];
  const Vector3 normal = cross(at[corners[1]] - at[corners[0]], at[corners[2]] - at[corners[0]]);
  const double length = std::sqrt(dot(normal, normal));
  double greatest = 0;
  for (const int edge : EdgesOfFaces[face])
  {
    const double rise = dot(departures.apart(edges[edge]), normal);
    greatest = std::max(greatest, length > 0 ? std::abs(rise) / length : 0);
  }
  return WithinFaces * greatest;
}

bool isOuter(const Piece& piece, int face)
{
  const int* corners = CornersOfFaces[face];
  return (piece[corners[0]].Faces & piece[corners[1]].Faces & piece[corners[2]].Faces) != 0;
}

} // namespace

std::uint32_t EdgeDepartures::add(const EdgeDeparture& departure)
{
  for (const double x : departure.Apart)
  {
    this->Places.push_back(static_cast<float>(x));
  }
  for (const double value : departure.Values)
  {
    this->Values.push_back(static_cast<float>(value));
  }
  this->Values.push_back(static_cast<float>(departure.Magnitude));
  this->Components = departure.Values.size();
  return static_cast<std::uint32_t>(this->Places.size() / 3 - 1);
}

Vector3 EdgeDepartures::apart(std::uint32_t edge) const
{
  const float* at = &this->Places[3 * std::size_t(edge)];
  return { { double(at[0]), double(at[1]), double(at[2]) } };
}

CurvedDeparture departureOf(const Piece& piece, const std::array<std::uint32_t, 6>& edges,
  const EdgeDepartures& departures, const OutputPoints& points)
{
  Corners at;
  for (int i = 0; i < 4; ++i)
  {
    at[i] = points.position(piece[i].Point.Id);
  }
  CurvedDeparture departure;
  for (int face = 0; face < 4; ++face)
  {
    if (isOuter(piece, face))
    {
      departure.Distance =
        std::max(departure.Distance, departureOfFace(at, face, edges, departures));
    }
  }
  const std::size_t components = departures.components();
  std::array<double, 4> values;
  double squares = 0;
  for (std::size_t c = 0; c < components; ++c)
  {
    std::transform(piece.begin(), piece.end(), values.begin(),
      [&](const PieceCorner& corner) { return points.value(corner.Point.Id, c); });
    const double ofComponent = departureOfValues(at, values, edges, departures, c);
    squares += ofComponent * ofComponent;
  }
  departure.Value = std::sqrt(squares);
  if (components > 1)
  {
    std::transform(piece.begin(), piece.end(), values.begin(),
      [&](const PieceCorner& corner) { return points.magnitude(corner.Point.Id); });
    departure.Value =
      std::max(departure.Value, departureOfValues(at, values, edges, departures, components));
  }
  return departure;
}

} // namespace tetmarch
