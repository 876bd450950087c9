// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One adversarial case: a grid, how it is looked at and coloured, and what is known of it
 */
#ifndef tetmarch_testing_HardCase_h
#define tetmarch_testing_HardCase_h

#include "GridBuilder.h"

#include <functional>
#include <string>
#include <vector>

class vtkCamera;
class vtkVolumeProperty;

namespace tetmarch::testing
{
/// An axis-aligned box, low and high corner.
struct Box
{
  Vec3 Low;
  Vec3 High;
};

/// What a ray through the mesh may be compared with, beside the same march in double.
enum class Answer
{
  Union, ///< its length in the union of the cells, by brute force, for some of the rays
  Box,   ///< the cells fill ExactBox: its chord of the box, for every ray
  None   ///< nothing more is known
};

/// A named camera position. Set places the camera (position, focal point, view up, angle or
/// parallel scale) for a grid; the clipping range is reset to the volume afterwards unless
/// KeepsClippingRange.
struct HardView
{
  std::string Name;
  std::function<void(vtkCamera*, vtkUnstructuredGrid*)> Set;
  bool KeepsClippingRange = false;
  int Pixels = 0; ///< the width and height of the one window it is meant for; 0: any
  /// Not for the GL of a machine without GPU: Mesa's llvmpipe ends a ray after 65535 rounds of its
  /// loops in all, which a ray along a thousand teeth takes.
  bool ReferenceOnly = false;
};

struct HardCase
{
  std::string Name;  ///< words and hyphens, unique, fit for a file's name: "needle-fan"
  std::string Group; ///< rays, cells, scale, optics, non-convex
  std::string What;  ///< one line for a reader who has never seen it

  /// Seeded, the same on every platform; point scalars "f", cell scalars "c".
  std::function<Grid()> Make;
  /// Empty: standardViews().
  std::vector<HardView> Views;
  /// Transfer functions and unit distance; empty: setStandardOptics().
  std::function<void(vtkVolumeProperty*, vtkUnstructuredGrid*)> SetOptics;
  bool CellScalars = false;
  /// Of the volume, row by row.
  std::array<double, 16> Matrix{ { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } };

  Answer Known = Answer::Union;
  Box ExactBox{}; ///< in the grid's coordinates, for Answer::Box
  /// The name of a case whose pictures must be the same within 1/255; empty: none.
  std::string SamePictureAs;
};

/// Every case, group by group; names are unique.
const std::vector<HardCase>& hardCases();
std::vector<std::string> hardCaseNames();
/// nullptr if there is none of that name.
const HardCase* findHardCase(const std::string& name);

/// The views of the case, or the standard ones.
std::vector<HardView> viewsOf(const HardCase& hard);
/// The width and height in pixels of a view that is meant for any window.
constexpr int HardPictureSize = 65;

/// Three views of the grid's bounding box: oblique in perspective, parallel along z, parallel along
/// the diagonal (1, 1, 1).
std::vector<HardView> standardViews();
/// A smooth colour map, an opacity with a bump, a ramp and a transparent gap over the finite range
/// of "f", and a unit distance such that the diagonal of the grid's bounding box has an optical
/// depth of about 3. (Cases of cell scalars bring their own SetOptics, over the range of "c".)
void setStandardOptics(vtkVolumeProperty* property, vtkUnstructuredGrid* grid);
} // namespace tetmarch::testing

#endif
