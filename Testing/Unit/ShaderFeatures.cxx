// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShaderFeatures.h"

#include <iterator>

namespace tetmarch::testing
{
namespace
{
using Key = VariantKey;

bool isIndependent(const Key& key) { return key.Components == ComponentGroup::Independent; }

const ShaderFeature OfTheMarch[] = {
  { "march of the picture", [](const Key& k, MarchShader s) { return gathers(k, s); },
    "Radiance March CellInterval Segment visibleSegment beginCellInterval gatherSegment pixelOf "
    "isOpaque marchToExit marchOn passCell passToSeenCell beginMarch noRadiance beginCell "
    "beginLookups keepLastDrawn decideVisibility advanceShades shadeCell cropCell gatherCell "
    "gatherInterval gatherIntervals isFinished goesOnAfter keepCell keepTransmittance countFaults "
    "countRefusal recordCell errorBound beginVisit goesOnThrough" },
  { "composites", [](const Key& k, MarchShader s) { return gathers(k, s) && k.isComposite(); },
    "Absorption absorption absorb addSubsegment integrateSegment thicknessWithin" },
  { "composites of volumes or surfaces",
    [](const Key& k, MarchShader s) { return gathers(k, s) && k.accumulatesOpacity(); },
    "emission placeShades" },
  { "tolerance", [](const Key& k, MarchShader) { return k.accumulatesOpacity(); },
    "givenTolerance errorTolerance" },
  { "segments of the picture",
    [](const Key& k, MarchShader s) {
      return gathers(k, s) && k.PointScalars && k.isComposite() && !k.PointSampled &&
             !cutsEvenly(k);
    },
    "SegmentEnds segmentEnds Subsegment subsegmentFrom SubsegmentMean meanOfSubsegment isLoaded "
    "keepTablePoint trials" },
  { "segments of one scalar",
    [](const Key& k, MarchShader s)
    {
      return gathers(k, s) && k.PointScalars && k.isComposite() && !k.hasComponents() &&
             !k.PointSampled && !cutsEvenly(k);
    },
    "positionWithin" },
  { "scalars along the picture's rays",
    [](const Key& k, MarchShader s)
    {
      return gathers(k, s) && k.PointScalars &&
             (!k.Structured || k.Cropped || k.PointSampled || isPick(s));
    },
    "scalarIn" },
  { "cells and samples of the picture",
    [](const Key& k, MarchShader s)
    { return gathers(k, s) && (!k.PointScalars || k.PointSampled) && k.isComposite(); },
    "constantMean" },
  { "tables", [](const Key& k, MarchShader) { return !isIsosurfaces(k); },
    "tableValueBuffer tableIntegralBuffer "
    "fetchTableValue fetchTableIntegral TablePoint tableBin tableValue tablePoint linearMean "
    "pointInBin meanBetween" },
  { "one table", [](const Key& k, MarchShader) { return !isIsosurfaces(k) && !k.hasComponents(); },
    "tableSize givenIntegralUnit tableIntegralUnit" },
  { "table of the first scalar",
    [](const Key& k, MarchShader) { return !isIsosurfaces(k) && !isIndependent(k); },
    "tableScale tableOffset" },
  { "components", [](const Key& k, MarchShader) { return k.hasComponents(); },
    "TableSpan tableSpan tableFirst tableSizes "
    "tableIntegralUnits tablePlace fetchTableFirst fetchTableSize fetchTableIntegralUnit "
    "fetchTablePlace" },
  { "components of tetrahedra",
    [](const Key& k, MarchShader) { return k.hasComponents() && !k.Structured; },
    "furtherScalarBuffer fetchFurtherScalars" },
  { "components along segments",
    [](const Key& k, MarchShader s)
    { return gathers(k, s) && k.hasComponents() && k.PointScalars; },
    "furtherEnd" },
  { "components where rays are cut",
    [](const Key& k, MarchShader s)
    {
      return gathers(k, s) && k.hasComponents() && k.PointScalars &&
             (!k.Structured || k.Cropped || k.PointSampled || isPick(s));
    },
    "furtherAt" },
  { "independent components", [](const Key& k, MarchShader) { return isIndependent(k); },
    "componentCount componentFactor scalarsOf componentOf" },
  { "independent components of points",
    [](const Key& k, MarchShader) { return isIndependent(k) && k.PointScalars; },
    "independentMeanBetween" },
  { "dependent components of points",
    [](const Key& k, MarchShader) { return k.isDependent() && k.PointScalars; },
    "DependentColor dependentColorBetween" },
  { "dependent components of cells",
    [](const Key& k, MarchShader) { return k.isDependent() && !k.PointScalars; },
    "dependentColorOf" },
  { "extreme scalars", [](const Key& k, MarchShader) { return k.Blend == BlendGroup::Extreme; },
    "extremeSign extreme extremeScalar" },
  { "sums of scalars", [](const Key& k, MarchShader) { return k.Blend == BlendGroup::Sum; },
    "averages averageRange counted countedFraction countedLength LongSum emptySum addTo valueOf "
    "factorOf" },
  { "surfaces", [](const Key& k, MarchShader) { return isIsosurfaces(k); },
    "isoSurfaceCount isoValue isoColor fetchIsoValue fetchIsoColor valuesReached crossesSurface "
    "surfaceEmission gatheredEnd drawn" },
  { "light on surfaces", [](const Key& k, MarchShader) { return isIsosurfaces(k) && k.isLit(); },
    "fractionOfValue" },
  { "rays of pixels", [](const Key&, MarchShader s) { return !isLight(s); }, "rayPoints rayPoint" },
  { "first entries",
    [](const Key& k, MarchShader s) { return !isLight(s) || k.Structured || k.Hierarchy; },
    "traversalFrom" },
  { "entries that are not listed",
    [](const Key& k, MarchShader s) { return !isLight(s) && !k.EntryLists; }, "cutsNearPlane" },
  { "opaque depth", [](const Key& k, MarchShader) { return k.OpaqueDepth; },
    "opaqueDepthTexture depthsPerPixel" },
  { "depths of the window", [](const Key& k, MarchShader) { return k.OpaqueDepth || k.Peeled; },
    "cutsFarPlane clipToNormalized unproject depthAt windowDepth" },
  { "parts between translucent geometry", [](const Key& k, MarchShader) { return k.Peeled; },
    "peeledRay initializeRayCast castRay g_opacityThreshold in_inverseWindowSize" },
  { "error bound", [](const Key& k, MarchShader) { return k.hasErrorBound() && !cutsEvenly(k); },
    "orderErrorFactor subsegmentError" },
  { "variations of the functions", [](const Key& k, MarchShader) { return k.needsVariations(); },
    "tableVariationBuffer variation fractionOfBin colorRise" },
  { "error bound of one scalar that is linear",
    [](const Key& k, MarchShader)
    { return k.hasErrorBound() && !k.hasComponents() && !k.Structured; },
    "fetchTableVariation" },
  { "error bound of several, or one that bends",
    [](const Key& k, MarchShader)
    { return k.needsVariations() && (k.hasComponents() || k.Structured); },
    "fetchTableVariations extinctionVariation" },
  { "error bound of independent components, or the planes that a ray crosses",
    [](const Key& k, MarchShader)
    { return k.Structured || (k.hasErrorBound() && isIndependent(k)); },
    "greatestOf" },
  { "error bound of dependent components",
    [](const Key& k, MarchShader) { return k.hasErrorBound() && k.isDependent(); }, "covariance" },
  { "adaptive", [](const Key& k, MarchShader) { return k.Adaptive; },
    "givenTrials mostTrials errorBudget TOLERANCE_AT_ONCE TOLERANCE_BY_ABSORPTION "
    "SHARE_OF_A_SUBSEGMENT "
    "budget" },
  { "diagnostics", [](const Key& k, MarchShader) { return k.Diagnostics; },
    "guarded met measuresOf troubleOf" },
  { "error by the steps of integrals", [](const Key& k, MarchShader) { return hasStepError(k); },
    "errorOfSteps lookedUp addLookup" },
  { "bins of a mean",
    [](const Key& k, MarchShader) { return hasStepError(k) && !isIndependent(k); },
    "perBinsBetween" },
  { "bins of the mean of a subsegment",
    [](const Key& k, MarchShader) { return hasStepError(k) && !cutsEvenly(k); }, "perBinsOf" },
  { "transparent ranges", [](const Key& k, MarchShader) { return k.TransparentRanges; },
    "givenTransparentRanges transparentRanges isTransparentBetween" },
  { "colour of what is not finite", [](const Key& k, MarchShader) { return k.NanShown; },
    "nanColor" },
  { "what is not finite in the picture",
    [](const Key& k, MarchShader s) { return gathers(k, s) && k.NanShown; }, "absorbNan finite" },
  { "hidden cells", [](const Key& k, MarchShader) { return k.HiddenCells; },
    "hiddenCellBuffer fetchHiddenCells isHidden" },
  { "crossing of cells", [](const Key& k, MarchShader s) { return gathers(k, s); },
    "Crossing crossing crossCell" },
  { "cells passed", [](const Key& k, MarchShader) { return k.passesCells(); }, "passing" },
  { "constant colour", [](const Key& k, MarchShader) { return k.ConstantColor; }, "constantColor" },
  { "clipping planes", [](const Key& k, MarchShader) { return k.Clipped; },
    "clippingPlaneCount clippingPlane fetchClippingPlane clippedRange" },
  { "cropping", [](const Key& k, MarchShader) { return k.Cropped; },
    "croppingLow croppingHigh croppingFlags lowDepth highDepth depthAlong planeDepths "
    "mostRanges nextPlane planesBelow isInRegionLeft nextRange nextRangeOfCell rest cropping" },
  { "rays of pixels", [](const Key&, MarchShader s) { return !isLight(s); }, "viewport eye" },
  { "one march a ray",
    [](const Key& k, MarchShader s)
    {
      return (isPicture(s) && !k.SampledShadows) || (isPick(s) && k.isKnownAtEnd()) ||
             (isLight(s) && k.Structured);
    },
    "castPlainRay" },
  { "lookups counted", [](const Key& k, MarchShader s) { return gathers(k, s) && !isPick(s); },
    "countLookups" },
  { "window of colours", [](const Key& k, MarchShader s) { return isPicture(s) && !k.Diagnostics; },
    "colorWindow windowed" },
  { "pick", [](const Key&, MarchShader s) { return isPick(s); },
    "Pick PICK_STEPS noPick isPicked gathered gatheredUpTo pickInterval pickedScalar pickOn "
    "transmittanceLeft" },
  { "pick where the scalar bends",
    [](const Key& k, MarchShader s) { return isPick(s) && k.Adaptive; }, "PICK_TOLERANCE" },
  { "pick of scalars", [](const Key& k, MarchShader s) { return isPick(s) && k.isKnownAtEnd(); },
    "PICK_ROUNDING" },
};
} // namespace

const char* const UnusedInSome = "main addLight bentScalar bentScalars castRay dimLight errorBound "
                                 "enters enterVolume initializeRayCast isOpaque leaveVolume "
                                 "isTurnedForSure meanBetween pixelOf scalarAt tablePoint "
                                 "tableValue texelOfVertex vertexOfTexel traversalFrom";

const std::vector<ShaderFeature>& shaderFeatures()
{
  static const std::vector<ShaderFeature> all = []
  {
    std::vector<ShaderFeature> features(std::begin(OfTheMarch), std::end(OfTheMarch));
    for (const std::vector<ShaderFeature>& further : { featuresOfVolumes(), featuresOfLight() })
    {
      features.insert(features.end(), further.begin(), further.end());
    }
    return features;
  }();
  return all;
}
} // namespace tetmarch::testing
