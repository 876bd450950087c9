// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShaderFeatures.h"

namespace tetmarch::testing
{
namespace
{
using Key = VariantKey;

bool isMesh(const Key& key) { return !key.Structured; }
bool isTrilinear(const Key& key) { return key.Structured && key.PointScalars; }
bool bendsWithError(const Key& key)
{
  return key.Structured && key.hasErrorBound() && !cutsEvenly(key);
}
bool bendsTogether(const Key& key) { return isTrilinear(key) && key.hasComponents(); }
} // namespace

std::vector<ShaderFeature> featuresOfVolumes()
{
  return {
    // Tetrahedra.
    { "tetrahedra", [](const Key& k, MarchShader) { return isMesh(k); },
      "vertexBuffer cellBuffer boundaryBuffer numberOfTets tetCount fetchVertex fetchCell "
      "fetchBoundaryFace project snapToPredicate projectionBlur edgeCross turnsLeft "
      "Side sideFrom isOutside linkDifference apexOf linkOf sideBehind replaceByExit "
      "isTurnedForSure FaceIntersection fetchCorners stepThrough intersectionPoint entersFace "
      "enters "
      "apex link LINK_OUTSIDE BVH_STACK PROJECTION_SCALE PROJECTION_FLUSH" },
    { "tetrahedra of the picture",
      [](const Key& k, MarchShader s) { return gathers(k, s) && isMesh(k); }, "cellScalar" },
    { "fused predicate", [](const Key& k, MarchShader) { return k.HasFma; },
      "fma GL_ARB_gpu_shader5" },
    { "portable predicate", [](const Key& k, MarchShader) { return isMesh(k) && !k.HasFma; },
      "wrapped turns" },
    { "scalars of tetrahedra",
      [](const Key& k, MarchShader) { return isMesh(k) && !k.PointScalars; },
      "cellScalarBuffer fetchCellScalar" },
    { "tetrahedra in two buffers", [](const Key& k, MarchShader) { return k.SplitCells; },
      "secondCellBuffer cellsOfFirstBuffer" },
    { "scalars of tetrahedra in two buffers",
      [](const Key& k, MarchShader) { return k.SplitCells && !k.PointScalars; },
      "secondCellScalarBuffer" },
    { "components of tetrahedra in two buffers",
      [](const Key& k, MarchShader)
      { return k.SplitCells && !k.PointScalars && k.hasComponents(); },
      "secondFurtherScalarBuffer" },
    { "gradients of tetrahedra in two buffers",
      [](const Key& k, MarchShader) { return k.SplitCells && k.CellGradients; },
      "secondGradientBuffer" },
    { "numbers of tetrahedra in two buffers",
      [](const Key& k, MarchShader)
      { return k.SplitCells && (!k.PointScalars || k.CellGradients); },
      "fetchOfCell" },
    { "hierarchy", [](const Key& k, MarchShader) { return k.Hierarchy; },
      "hierarchyBuffer bvhNodeCount bvhReentryNodeCount reentryFaceCount fetchBvhNode nextEntry" },
    { "entry lists", [](const Key& k, MarchShader) { return k.EntryLists; },
      "entryTileBuffer entryCandidateBuffer entryTileShift entryTilesPerRow entryDepthPlane "
      "fetchEntryCandidate fetchCandidateRange pixelInTile firstCandidate endOfCandidates "
      "isForPixel nextCandidate bestAt entersListed sideOfListed" },
    { "visible part", [](const Key& k, MarchShader) { return k.VisiblePart; },
      "visibleTetBuffer visibleFaceBuffer visibleLinkBuffer fetchVisibleTets fetchVisibleFace "
      "fetchVisibleLink isInVisiblePart" },
    { "ways out of the mesh that are searched",
      [](const Key& k, MarchShader s)
      { return isMesh(k) && (isLight(s) || !k.EntryLists || k.SampledShadows); },
      "enterBySearch leaveBySearch" },
    { "order of entries", [](const Key& k, MarchShader) { return k.EntryLists || k.Hierarchy; },
      "isBefore" },
    { "rays to lights through tetrahedra",
      [](const Key& k, MarchShader s) { return followsLight(k, s) && isMesh(k); },
      "INSIDE_FACE Tet tetBehind sideOpposite projectedVertex entersTet ExtinctionMarch "
      "marchExtinctionToExit "
      "marchExtinction transmittanceOn" },
    { "extinction of what is not finite",
      [](const Key& k, MarchShader s) { return followsLight(k, s) && isMesh(k) && k.NanShown; },
      "isFinite" },
    { "extinction along a segment",
      [](const Key& k, MarchShader s) { return followsLight(k, s) && isMesh(k) && k.PointScalars; },
      "extinctionBetween" },
    { "extinction of a tetrahedron",
      [](const Key& k, MarchShader s)
      { return followsLight(k, s) && isMesh(k) && !k.PointScalars; },
      "extinctionOf" },
    { "extinction by gradients at vertices",
      [](const Key& k, MarchShader s)
      { return followsLight(k, s) && isMesh(k) && k.GradientOpacity && k.hasVertexGradients(); },
      "densityAt densityBetween" },
    // Lattices.
    { "lattice", [](const Key& k, MarchShader) { return k.Structured; },
      "valueMap latticeCells firstValue lastValue latticeMatrix toLattice "
      "directionToLattice perSlope steps stepAlong perSlopeOf planesAt cellAround "
      "planesAhead planesPassed crossingDepths leastOf depthsOfLattice corrected cellBehindDepth "
      "numberOfCell never neverAlong nextCell enterCell isWithinCell LEAP_SHIFT" },
    { "values in one texture", [](const Key& k, MarchShader) { return k.Structured && !k.Slabs; },
      "valueTexture" },
    { "values in slabs", [](const Key& k, MarchShader) { return k.Slabs; },
      "slabTextures slabLayers readSlab readSlabs" },
    { "even planes", [](const Key& k, MarchShader) { return k.Structured && !k.Rectilinear; },
      "latticeShift latticeHalfLength planeAt" },
    { "planes of their own", [](const Key& k, MarchShader) { return k.Rectilinear; },
      "planeBuffer firstPlane fetchPlane planeBelow" },
    { "trilinear cells", [](const Key& k, MarchShader) { return isTrilinear(k); },
      "fetchValues CellFrame cellFrame cubic cubicAlong cubicAt bend "
      "bentScalar bendWithin" },
    { "parts of trilinear cells",
      [](const Key& k, MarchShader) { return isTrilinear(k) && !cutsEvenly(k); },
      "takePart NO_EXTREME extremesOf extremes" },
    { "trilinear cells cut evenly", [](const Key& k, MarchShader) { return cutsEvenly(k); },
      "takeCell IntegralPoint integralPoint meanByDifference LEAST_RISE GREATEST_BEND MOST_PIECES "
      "piecesOf meanOfPiece" },
    { "error of pieces",
      [](const Key& k, MarchShader) { return cutsEvenly(k) && k.hasErrorBound(); },
      "errorOfPiece" },
    { "constant cells of a lattice",
      [](const Key& k, MarchShader) { return k.Structured && !k.PointScalars; }, "fetchValue" },
    { "error of the bend", [](const Key& k, MarchShader) { return bendsWithError(k); }, "bent" },
    { "bend within a table",
      [](const Key& k, MarchShader)
      { return k.Structured && (k.needsVariations() || cutsEvenly(k)); },
      "greatestBend" },
    { "shift of a scalar's place",
      [](const Key& k, MarchShader)
      { return k.Structured && k.needsVariations() && !cutsEvenly(k); },
      "greatestShift" },
    { "shift of the mean",
      [](const Key& k, MarchShader)
      { return k.Structured && !k.hasComponents() && (k.needsVariations() || cutsEvenly(k)); },
      "bentShare" },
    { "bend of one scalar",
      [](const Key& k, MarchShader)
      { return k.Structured && k.needsVariations() && !k.hasComponents() && !cutsEvenly(k); },
      "fetchTableSlopeVariations slopeVariation bentMean bentMeanError bendMean "
      "bentError "
      "weightedByExtinction" },
    { "error of the bend of one scalar",
      [](const Key& k, MarchShader) { return bendsWithError(k) && !k.hasComponents(); }, "unbent" },
    { "error of the bend of the scalar that gives the opacity",
      [](const Key& k, MarchShader)
      { return bendsWithError(k) && k.Components != ComponentGroup::Independent; },
      "bendError" },
    // Of several components.
    { "components of lattices",
      [](const Key& k, MarchShader) { return k.Structured && k.hasComponents(); }, "furtherMap" },
    { "components in one texture each",
      [](const Key& k, MarchShader) { return k.Structured && k.hasComponents() && !k.Slabs; },
      "furtherTextureA" },
    { "components in one texture each, beyond two",
      [](const Key& k, MarchShader)
      {
        return k.Structured && k.hasComponents() && !k.Slabs &&
               k.Components != ComponentGroup::ColorAndOpacity;
      },
      "furtherTextureB furtherTextureC" },
    { "components in slabs", [](const Key& k, MarchShader) { return k.Slabs && k.hasComponents(); },
      "furtherLayers" },
    { "components of constant cells",
      [](const Key& k, MarchShader)
      { return k.Structured && !k.PointScalars && k.hasComponents(); },
      "fetchFurtherValues" },
    { "components of trilinear cells", [](const Key& k, MarchShader) { return bendsTogether(k); },
      "fetchValuesOf cubicOfComponent FurtherBend FurtherCubics noFurtherCubics "
      "furtherCubicsAt furtherCubicsAlong furtherBendWithin bentScalars furtherEnter furtherLeave "
      "furtherBend" },
    { "components of trilinear cells in one texture each",
      [](const Key& k, MarchShader) { return bendsTogether(k) && !k.Slabs; }, "readValues" },
    { "extremes of components",
      [](const Key& k, MarchShader)
      { return bendsTogether(k) && k.Components != ComponentGroup::DirectColor; },
      "nextOf nextFurtherExtreme firstExtremes secondExtremes" },
    { "independent components that bend",
      [](const Key& k, MarchShader)
      { return bendsTogether(k) && k.Components == ComponentGroup::Independent; },
      "scalarsWithin endsWithin" },
    { "error of the bends of independent components",
      [](const Key& k, MarchShader) {
        return bendsTogether(k) && k.hasErrorBound() && k.Components == ComponentGroup::Independent;
      },
      "IndependentBend noBend addBend independentBend" },
    { "error of the bends of dependent components",
      [](const Key& k, MarchShader)
      { return bendsTogether(k) && k.hasErrorBound() && k.isDependent(); },
      "DependentBend dependentBend bendShift" },
    { "error of direct colours that bend",
      [](const Key& k, MarchShader) {
        return bendsTogether(k) && k.hasErrorBound() && k.Components == ComponentGroup::DirectColor;
      },
      "bentVariation" },
    { "leaps", [](const Key& k, MarchShader) { return k.Leaps; },
      "blockDistanceBuffer blockCount fetchBlockDistance leapOf blockOf cubeEnd landingAlong "
      "landingOf leap leaps cellBehind" },
    { "samples", [](const Key& k, MarchShader) { return k.PointSampled; },
      "sampleStep samplesPerDepth sampleShift firstSample placeSamples shiftSamples samplesBefore "
      "stepThickness SAMPLE_SHIFT" },
    { "places of samples",
      [](const Key& k, MarchShader)
      { return k.PointSampled && (k.PointScalars || k.hasGradients()); },
      "depthOfSample" },
    { "samples in light",
      [](const Key& k, MarchShader) { return k.PointSampled && k.hasGradients(); }, "shadeSample" },
    { "extinction along samples' rays through a lattice",
      [](const Key& k, MarchShader) { return k.Structured && k.SampledShadows; },
      "meanExtinction" },
    { "vertices with light", [](const Key& k, MarchShader s) { return isLight(s) && isMesh(k); },
      "vertexStartBuffer fetchVertexStart" },
    { "nodes of light",
      [](const Key& k, MarchShader s)
      { return k.Structured && (isLight(s) || k.hasVertexLight()); },
      "lightNodes" },
    { "nodes where light is made",
      [](const Key& k, MarchShader s) { return k.Structured && isLight(s); },
      "lightNodeMatrix pointOfNode" },
    { "light between nodes",
      [](const Key& k, MarchShader) { return k.Structured && k.hasVertexLight(); },
      "lightLow perLightStep fetchNodeLight keptLightAt" },
  };
}
} // namespace tetmarch::testing
