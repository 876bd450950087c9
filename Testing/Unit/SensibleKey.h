// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a filtered key of a variant is, said without the filter
 */
#ifndef tetmarch_testing_SensibleKey_h
#define tetmarch_testing_SensibleKey_h

#include "Variants/VariantKey.h"

namespace tetmarch::testing
{
/// Whether each feature of the key changes something; in the words of the members, one by one.
inline bool isSensible(const VariantKey& k)
{
  const bool composite = k.Blend == BlendGroup::Composite;
  const bool ofScalars = k.Blend == BlendGroup::Extreme || k.Blend == BlendGroup::Sum;
  const bool several = k.Components != ComponentGroup::Single;
  const bool independent = k.Components == ComponentGroup::Independent;
  const bool ofLight = k.HeadlightOnly || k.SingleLight || k.WorldLights || k.Scattering ||
                       k.CastShadows || k.SampledShadows || k.SeveralShadows || k.OpaqueShadows ||
                       k.HeadlightShadows || k.Occlusion || k.LightTolerance ||
                       k.LightThroughCuts || k.FewLights;
  // Rays enter a lattice through its planes, without lists or predicates.
  const bool ofTetrahedra =
    k.EntryLists || k.Hierarchy || k.HasFma || k.SplitCells || k.Curvilinear;
  return !(k.Structured && ofTetrahedra) &&
         !(!k.Structured && (k.Rectilinear || k.Octree || k.Leaps)) &&
         // Who enters a part by a list enters it again.
         !(k.Reentered && (!k.EntryLists || k.Blend == BlendGroup::Isosurfaces)) &&
         !(k.VisiblePart && k.Blend != BlendGroup::Isosurfaces && !k.Reentered) &&
         // All that a ray meets counts; and so do surfaces between cells. Most is transparent where
         // there are blocks of it.
         !(k.Leaps && (ofScalars || (!composite && !k.PointScalars))) &&
         !(k.Structured && k.TransparentRanges && !k.Leaps) &&
         // Who has no list of where a ray comes into a mesh has to look for it; who has one looks
         // on the way to lights alone.
         (k.Structured || k.EntryLists || k.Hierarchy) &&
         !(k.EntryLists && k.Hierarchy && !k.SampledShadows) &&
         // Leaves of trees have constant scalars in one texture, aren't sampled, and there are no
         // blocks of them.
         !(k.Octree && (k.PointScalars || k.Leaps || k.Slabs || k.PointSampled)) &&
         // Parts of rays end where they are asked to, and aren't counted.
         !(k.Peeled && (k.OpaqueDepth || k.Diagnostics)) &&
         // What is cropped may be clipped, too.
         (k.Clipped || !k.Cropped) &&
         // Of surfaces alone light and gradients are seen, of scalars alone nothing but they.
         !(!composite && (k.Adaptive || k.TransparentRanges || k.ConstantColor || k.NanShown ||
                           k.GradientOpacity || k.Scattering || k.CastShadows ||
                           k.HeadlightShadows || k.Occlusion)) &&
         !(ofScalars && (k.Shading || k.ShowIllumination || k.ShowGradients)) &&
         // Several scalars are mixed in one way, where there is a volume of several colours;
         // independent ones in light without shadows, and cells that one of them doesn't
         // show another may.
         !(several && (!composite || k.ConstantColor)) &&
         !(independent &&
           (k.TransparentRanges || k.GradientOpacity || k.CellGradients || k.LightTolerance ||
             k.Scattering || k.CastShadows || k.HeadlightShadows || k.Occlusion ||
             k.ShowIllumination || k.ShowGradients)) &&
         // Computed tetrahedra are in no buffer. Their corners have the scalars of the points. Only
         // grids of them have sides that meet.
         !(k.Curvilinear && (k.SplitCells || k.CornerScalars)) &&
         (k.Curvilinear || !k.JoinedSides) &&
         // Where errors are counted, and cells of one scalar were cut; one that is transparent may
         // be a visible one.
         !(k.CurvedError && (!k.Diagnostics || !composite || k.Structured || k.Curvilinear ||
                              several || k.VisiblePart || k.TransparentRanges)) &&
         // Corners have one scalar, of points, and vertices no gradient there.
         !(k.CornerScalars &&
           (!k.PointScalars || k.Structured || several ||
             (!k.CellGradients && (k.GradientOpacity || k.Shading || k.ShowGradients)))) &&
         // A constant is integrated exactly and has no gradient in a cell.
         !(!k.PointScalars && (k.Adaptive || k.CellGradients)) &&
         !(k.ConstantColor && k.Adaptive && !k.Structured) &&
         // No colour of the volume is seen.
         !(k.ConstantColor && (k.ShowIllumination || k.ShowGradients)) &&
         // Nothing uses gradients.
         !(k.CellGradients && !k.GradientOpacity && !k.Shading && !k.ShowGradients) &&
         // There is no light.
         !(ofLight && !k.Shading) &&
         // The only light stands at the eye, and needs no world.
         !(k.HeadlightOnly && (k.SingleLight || k.WorldLights || k.CastShadows)) &&
         // A software renderer has a few lights of its own kind.
         !(k.FewLights && (k.HeadlightOnly || k.SingleLight || k.HasFma || k.Structured)) &&
         // Or elsewhere.
         !(k.SingleLight && (k.SeveralShadows || k.HeadlightShadows)) &&
         // No shadows to be sampled.
         !(k.SeveralShadows && !k.CastShadows) &&
         !(k.SampledShadows && !k.CastShadows && !(k.Occlusion && k.LightTolerance)) &&
         // Light at vertices keeps no tolerance.
         !(k.LightTolerance && !k.SampledShadows && (k.CastShadows || k.Occlusion)) &&
         // Nor do samples of a ray, nor surfaces.
         !(k.LightTolerance && (!composite || k.PointSampled)) &&
         // Nor does the light of gradients of cells, unless shadows are sampled.
         !(k.LightTolerance && k.CellGradients && !k.Structured && !k.SampledShadows) &&
         // Nor does that which is the same in the whole of a constant cell.
         !(k.LightTolerance && k.Structured && !k.PointScalars && !k.WorldLights &&
           !k.CastShadows && !k.Occlusion) &&
         // No light that a cut could let through.
         !(k.LightThroughCuts && !(k.Clipped && (k.CastShadows || k.Occlusion))) &&
         // No light that opaque geometry could keep off.
         !(k.OpaqueShadows && !k.CastShadows) &&
         // Only lattices of one scalar are sampled, in one blend mode and without a tolerance.
         !(k.PointSampled && (!k.Structured || !composite || several || k.Adaptive)) &&
         // Only values of a lattice lie in several textures, and many are several; so are those of
         // several scalars.
         !(k.Slabs && !k.Structured) && !(k.ManySlabs && !k.Slabs) &&
         !(k.Slabs && several && !k.ManySlabs) &&
         // Rays enter a part of a mesh by lists, and little of it is transparent.
         !(k.VisiblePart && (!k.EntryLists || k.TransparentRanges)) &&
         // Gradients are shown instead of the light.
         !(k.ShowGradients && (k.Shading || k.ShowIllumination));
}
} // namespace tetmarch::testing

#endif
