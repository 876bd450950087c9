// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Gradients of the scalar, at vertices and in tetrahedra.
#ifndef TetMarchMeshGradients_h
#define TetMarchMeshGradients_h

#include "Mesh/TetMesh.h"

namespace tetmarch
{

class Group;

/** Of the stored scalar (0..1) in the normalised frame (mesh radius 1). */
using Gradient = std::array<float, 3>;

/**
 * At each vertex, of point scalars (Vertex::Scalar): the least-squares fit of the changes along its
 * edges, weighted by the inverse squared length (D. J. Mavriplis, "Revisiting the least-squares
 * procedure for gradient reconstruction on unstructured meshes", AIAA 2003-3986; for volume
 * rendering C. D. Correa, R. Hero, K.-L. Ma, "A comparison of gradient estimation methods for
 * volume rendering on unstructured meshes", IEEE TVCG 17(3), 2011). Where the edges don't determine
 * it, the mean of the gradients of the tetrahedra, weighted by volume.
 *
 * Compared with that mean everywhere, which has larger errors (GradientErrorsTest; relative RMS
 * errors of a quadratic and of a sine field, fit against mean):
 *
 *     jittered lattice, 16^3 cubes     0.034 / 0.045    0.089 / 0.097
 *     graded                           0.056 / 0.064    0.121 / 0.144
 *     layers squashed to a tenth       0.051 / 0.076    0.171 / 0.209
 *     thin layers on an arc            0.031 / 0.040    0.066 / 0.085
 *     warped hexahedra                 0.050 / 0.066    0.129 / 0.145
 *     mixed cells                      0.047 / 0.066    0.123 / 0.136
 *
 * The gain is mostly at the boundary (jittered lattice, sine: 0.142 / 0.163), and for the quadratic
 * field also inside (0.015 / 0.021); inside it can be slightly worse (sine: 0.059 / 0.057). Only in
 * thin curved layers of strongly skewed cells without edges straight across is it two or three
 * times worse (0.506 / 0.263, 2.07 / 0.75), and there neither is useful. Both are exact for linear
 * fields, of first order in the size of cells, and of second order inside where edges come in
 * opposite pairs.
 *
 * Tetrahedra with a corner of UndrawnScalar, and those that are flat to within the rounding of
 * positions (volumeSign()), are excluded; 0 at vertices without other tetrahedra. Always finite.
 *
 * With a group, whose processes have pieces of the mesh, it is collective: at shared vertices,
 * edges and tetrahedra of all pieces count.
 */
std::vector<Gradient> vertexGradients(const TetMesh& mesh, Group* group = nullptr);

/** At each vertex, of cell scalars (one per tetrahedron): gradients of their vertex scalars
 * (VertexScalars.h). */
std::vector<Gradient> vertexGradients(
  const TetMesh& mesh, const std::vector<float>& cellScalars, Group* group = nullptr);

/** At each vertex, of several scalars: as many gradients a vertex, of the first and the extra ones,
 * whose values are one after the other for each vertex or, if the first ones of cells are given,
 * for each tetrahedron. */
std::vector<Gradient> componentGradients(const TetMesh& mesh,
  const std::vector<float>& firstOfCells, const std::vector<float>& extra, std::size_t extraCount,
  Group* group = nullptr);

/** In a tetrahedron that has a volume, of the scalars of its corners. */
Vector3 gradientIn(const TetMesh& mesh, Id tet, const std::array<float, 4>& scalars);

/** In each tetrahedron, of point scalars or, unless this list is empty, of scalars of its corners.
 * Exact, since the scalar is linear there. 0 where the tetrahedron is flat or not drawn. */
std::vector<Gradient> cellGradients(
  const TetMesh& mesh, const std::vector<std::array<float, 4>>& corners = {});

} // namespace tetmarch

#endif
