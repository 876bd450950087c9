// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_DefaultCamera_h
#define tetmarch_DefaultCamera_h

class vtkCamera;

namespace tetmarch
{

/**
 * Look obliquely along +y and a little down, z up, from where the box just fits into a picture of
 * the given width / height, with a margin of a 20th. VTK's ResetCamera() fits the sphere around the
 * box, which leaves long meshes small.
 */
void PlaceDefaultCamera(vtkCamera* camera, const double bounds[6], double aspect);

} // namespace tetmarch

#endif
