// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShaderFeatures.h"

namespace tetmarch::testing
{
namespace
{
using Key = VariantKey;

bool isPicture(MarchShader shader) { return shader == MarchShader::Picture; }

bool isLight(MarchShader shader) { return shader == MarchShader::LightAtVertex; }
bool isPick(MarchShader shader) { return shader == MarchShader::Pick; }

// Gathers what the picture shows.
bool gathers(MarchShader shader) { return isPicture(shader) || isPick(shader); }

bool followsLight(const Key& key, MarchShader shader)
{
  return isLight(shader) || key.SampledShadows;
}

bool isIndependent(const Key& key) { return key.Components == ComponentGroup::Independent; }
bool isIsosurfaces(const Key& key) { return key.Blend == BlendGroup::Isosurfaces; }
} // namespace

const char* const UnusedInSome =
  "main addLight castRay dimLight errorBound initializeRayCast insideFace isOpaque "
  "isTurnedForSure meanBetween pixelOf scalarAt tablePoint "
  "tableValue texelOfVertex vertexOfTexel traversalFromBoundary";

const std::vector<ShaderFeature>& shaderFeatures()
{
  static const std::vector<ShaderFeature> features = {
    // The march.
    { "fused predicate", [](const Key& k, MarchShader) { return k.HasFma; },
      "fma GL_ARB_gpu_shader5" },
    { "portable predicate", [](const Key& k, MarchShader) { return !k.HasFma; }, "wrapped turns" },
    { "march of the picture", [](const Key&, MarchShader s) { return gathers(s); },
      "Radiance March CellInterval Segment visibleSegment beginCellInterval gatherSegment pixelOf "
      "isOpaque marchToExit marchOn passCell" },
    { "composites", [](const Key& k, MarchShader s) { return gathers(s) && k.isComposite(); },
      "Absorption absorption absorb addSubsegment integrateSegment thicknessWithin" },
    { "composites of volumes or surfaces",
      [](const Key& k, MarchShader s) { return gathers(s) && k.accumulatesOpacity(); },
      "emission placeShades" },
    { "tolerance", [](const Key& k, MarchShader) { return k.accumulatesOpacity(); },
      "errorTolerance" },
    { "segments of the picture",
      [](const Key& k, MarchShader s) { return gathers(s) && k.PointScalars && k.isComposite(); },
      "SegmentEnds segmentEnds Subsegment subsegmentFrom SubsegmentMean meanOfSubsegment isLoaded "
      "keepTablePoint trials" },
    { "cells of the picture",
      [](const Key& k, MarchShader s) { return gathers(s) && !k.PointScalars && k.isComposite(); },
      "constantMean" },
    { "tables", [](const Key& k, MarchShader) { return !isIsosurfaces(k); },
      "tableValueBuffer tableIntegralBuffer "
      "fetchTableValue fetchTableIntegral TablePoint tableBin tableValue tablePoint linearMean "
      "meanBetween" },
    { "one table",
      [](const Key& k, MarchShader) { return !isIsosurfaces(k) && !k.hasComponents(); },
      "tableSize tableIntegralUnit" },
    { "table of the first scalar",
      [](const Key& k, MarchShader) { return !isIsosurfaces(k) && !isIndependent(k); },
      "tableScale tableOffset" },
    { "components", [](const Key& k, MarchShader) { return k.hasComponents(); },
      "furtherScalarBuffer fetchFurtherScalars TableSpan tableSpan tableFirst tableSizes "
      "tableIntegralUnits tablePlace fetchTableFirst fetchTableSize fetchTableIntegralUnit "
      "fetchTablePlace" },
    { "components along segments",
      [](const Key& k, MarchShader s) { return gathers(s) && k.hasComponents() && k.PointScalars; },
      "furtherAt furtherEnd" },
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
      "averages averageRange counted countedFraction countedLength" },
    { "surfaces", [](const Key& k, MarchShader) { return isIsosurfaces(k); },
      "isoSurfaceCount isoValue isoColor fetchIsoValue fetchIsoColor valuesReached crossesSurface "
      "surfaceEmission gatheredEnd drawn" },
    { "light on surfaces", [](const Key& k, MarchShader) { return isIsosurfaces(k) && k.isLit(); },
      "fractionOfValue" },
    { "scalars of cells", [](const Key& k, MarchShader) { return !k.PointScalars; },
      "cellScalarBuffer fetchCellScalar" },
    { "hierarchy", [](const Key& k, MarchShader) { return k.Hierarchy; },
      "hierarchyBuffer bvhNodeCount bvhReentryNodeCount reentryFaceCount fetchBvhNode isBefore "
      "nextEntry" },
    { "ray points", [](const Key& k, MarchShader s) { return !isLight(s) && k.Hierarchy; },
      "rayPoints rayPoint" },
    { "rasterised entries",
      [](const Key& k, MarchShader s) { return !isLight(s) && k.RasterEntry; },
      "entryTexture insideFace" },
    { "search beside entries",
      [](const Key& k, MarchShader s) { return !isLight(s) && k.RasterEntry && k.Hierarchy; },
      "isBesideEntry known" },
    { "searched entries", [](const Key& k, MarchShader s) { return !isLight(s) && !k.RasterEntry; },
      "cutsNearPlane" },
    { "opaque depth", [](const Key& k, MarchShader) { return k.OpaqueDepth; },
      "opaqueDepthTexture depthsPerPixel" },
    { "depths of the window", [](const Key& k, MarchShader) { return k.OpaqueDepth || k.Peeled; },
      "cutsFarPlane clipToNormalized unproject depthAt windowDepth" },
    { "parts between translucent geometry", [](const Key& k, MarchShader) { return k.Peeled; },
      "peeledRay initializeRayCast castRay g_opacityThreshold in_inverseWindowSize" },
    { "error bound", [](const Key& k, MarchShader) { return k.hasErrorBound(); },
      "tableVariationBuffer variation orderErrorFactor subsegmentError" },
    { "error bound of one scalar",
      [](const Key& k, MarchShader) { return k.hasErrorBound() && !k.hasComponents(); },
      "fetchTableVariation" },
    { "error bound of several",
      [](const Key& k, MarchShader) { return k.hasErrorBound() && k.hasComponents(); },
      "fetchTableVariations extinctionVariation" },
    { "error bound of independent components",
      [](const Key& k, MarchShader) { return k.hasErrorBound() && isIndependent(k); },
      "greatestOf" },
    { "error bound of dependent components",
      [](const Key& k, MarchShader) { return k.hasErrorBound() && k.isDependent(); },
      "covariance" },
    { "adaptive", [](const Key& k, MarchShader) { return k.Adaptive; },
      "mostTrials errorBudget TOLERANCE_AT_ONCE TOLERANCE_BY_ABSORPTION budget" },
    { "diagnostics", [](const Key& k, MarchShader) { return k.Diagnostics; }, "lost guarded met" },
    { "transparent ranges", [](const Key& k, MarchShader) { return k.TransparentRanges; },
      "transparentRanges isTransparentBetween" },
    { "colour of what is not finite", [](const Key& k, MarchShader) { return k.NanShown; },
      "nanColor" },
    { "what is not finite in the picture",
      [](const Key& k, MarchShader s) { return gathers(s) && k.NanShown; }, "absorbNan finite" },
    { "hidden cells", [](const Key& k, MarchShader) { return k.HiddenCells; },
      "hiddenCellBuffer fetchHiddenCells isHidden" },
    { "cells passed", [](const Key& k, MarchShader) { return k.passesCells(); }, "passing" },
    { "constant colour", [](const Key& k, MarchShader) { return k.ConstantColor; },
      "constantColor" },
    { "clipping planes", [](const Key& k, MarchShader) { return k.Clipped; },
      "clippingPlaneCount clippingPlane fetchClippingPlane clippedRange" },
    { "cropping", [](const Key& k, MarchShader) { return k.Cropped; },
      "croppingLow croppingHigh croppingFlags lowDepth highDepth depthAlong planeDepths "
      "nextPlane planesBelow isInRegionLeft nextRange nextRangeOfCell rest cropping" },
    { "rays of pixels", [](const Key&, MarchShader s) { return !isLight(s); }, "viewport eye" },
    { "one march a ray",
      [](const Key& k, MarchShader s)
      { return (isPicture(s) && !k.SampledShadows) || (isPick(s) && k.isKnownAtEnd()); },
      "castPlainRay" },
    { "lookups counted", [](const Key&, MarchShader s) { return isPicture(s); }, "countLookups" },
    { "pick", [](const Key&, MarchShader s) { return isPick(s); },
      "Pick PICK_STEPS noPick isPicked gathered gatheredUpTo pickInterval pickedScalar pickOn "
      "transmittanceLeft" },
    { "pick of scalars", [](const Key& k, MarchShader s) { return isPick(s) && k.isKnownAtEnd(); },
      "PICK_ROUNDING" },
    // Gradients.
    { "gradients", [](const Key& k, MarchShader) { return k.hasGradients(); }, "gradientBuffer" },
    { "shades", [](const Key& k, MarchShader s) { return gathers(s) && k.hasGradients(); },
      "Shade CellShades FacePoint shadeOf leavePoint shades incomingAt fractionOfCell "
      "rangeWithin" },
    { "gradients at vertices", [](const Key& k, MarchShader) { return k.hasVertexGradients(); },
      "fetchGradient" },
    { "shades where rays enter cells",
      [](const Key& k, MarchShader s)
      { return gathers(s) && k.hasGradients() && (!k.hasVertexGradients() || k.passesCells()); },
      "enterPoint" },
    { "shades at faces",
      [](const Key& k, MarchShader s) { return gathers(s) && k.hasVertexGradients(); },
      "shadeAtFace" },
    { "shades where something is seen",
      [](const Key& k, MarchShader s)
      { return gathers(s) && k.hasVertexGradients() && k.passesCells(); },
      "enterKnown missing" },
    { "gradients of cells", [](const Key& k, MarchShader) { return k.CellGradients; },
      "fetchCellGradient" },
    { "attributes of vertices",
      [](const Key& k, MarchShader) {
        return k.hasVertexGradients() || k.hasVertexLight() ||
               (k.hasComponents() && k.PointScalars);
      },
      "VertexAttributes fetchAttributes selectAttributes interpolateAttributes attributesAt "
      "attributesA attributesB attributesC barycentricsOf" },
    { "attributes of vertices along the ray",
      [](const Key& k, MarchShader s)
      {
        return gathers(s) && (k.hasVertexGradients() || k.hasVertexLight() ||
                               (k.hasComponents() && k.PointScalars));
      },
      "enterAttributes leaveAttributes" },
    { "opacity by gradients", [](const Key& k, MarchShader) { return k.GradientOpacity; },
      "gradientOpacityBuffer gradientOpacitySize gradientOpacityScale fetchGradientOpacity "
      "gradientOpacity" },
    { "density of shades",
      [](const Key& k, MarchShader s) { return gathers(s) && k.GradientOpacity; },
      "density densityWithin" },
    { "gradients shown", [](const Key& k, MarchShader) { return k.ShowGradients; },
      "gradientColor" },
    // Light.
    { "light", [](const Key& k, MarchShader) { return k.isLit(); },
      "Light Illumination lit direct diffuse specular noLight addLight dimLight mixLight "
      "noIllumination mixIllumination illuminationWithin reflection" },
    { "light of segments", [](const Key& k, MarchShader) { return k.isLit() && k.isComposite(); },
      "litEmission" },
    { "error of light",
      [](const Key& k, MarchShader)
      { return k.isLit() && (k.hasErrorBound() || (k.Diagnostics && k.isComposite())); },
      "greatest" },
    { "brightness", [](const Key& k, MarchShader) { return k.isLit() && k.hasErrorBound(); },
      "brightness bright" },
    { "change of light",
      [](const Key& k, MarchShader) { return k.isLit() && k.Diagnostics && k.isComposite(); },
      "lightError changeOf lightErrorOf" },
    { "error of light between vertices",
      [](const Key& k, MarchShader) { return k.isLit() && k.Diagnostics && k.hasVertexLight(); },
      "interpolationError lightInterpolationError" },
    { "shading", [](const Key& k, MarchShader) { return k.Shading; },
      "twoSided ambientColor specularPower lightDiffuse lightSpecular fetchLightDiffuse "
      "fetchLightSpecular toEye directionOfLight LIGHT_COUNT diffuseOf specularOf illuminate" },
    { "lights elsewhere", [](const Key& k, MarchShader) { return k.Shading && !k.HeadlightOnly; },
      "lightPlace fetchLightPlace" },
    { "several lights",
      [](const Key& k, MarchShader) { return k.Shading && !k.HeadlightOnly && !k.SingleLight; },
      "lightCount lightKind isHeadlight" },
    { "lights in the world", [](const Key& k, MarchShader) { return k.WorldLights; },
      "worldMatrix normalMatrix toWorld toWorldNormal lightAttenuation lightCone "
      "fetchLightAttenuation "
      "fetchLightCone spot" },
    { "scattering", [](const Key& k, MarchShader) { return k.Scattering; },
      "scatteringBlending gradientUnit scatteredFraction scattered" },
    { "shadows", [](const Key& k, MarchShader) { return k.hasShadows(); },
      "shadowStrength shadowChannel fetchShadowStrength fetchShadowChannel addShadowed" },
    { "shadows of headlights", [](const Key& k, MarchShader) { return k.HeadlightShadows; },
      "head" },
    { "sampled shadows", [](const Key& k, MarchShader) { return k.SampledShadows; },
      "jitterTexture jitter keepPending addPending SamplePause noPause pause due nextSample "
      "sampleLight marchAndSample castSampledRay seenFraction seenDepth SAMPLE_SPACING "
      "FIRST_SAMPLE" },
    { "light past the volume or opaque geometry",
      [](const Key& k, MarchShader s)
      { return isPicture(s) && k.CastShadows && (!k.SampledShadows || k.OpaqueShadows); },
      "incomingFrom" },
    { "shadows of opaque geometry",
      [](const Key& k, MarchShader s) { return isLight(s) && k.OpaqueShadows; },
      "opaqueShadowBuffer fetchOpaqueShadows isShadowed" },
    { "light kept at vertices", [](const Key& k, MarchShader) { return k.hasVertexLight(); },
      "vertexLightTexture fetchVertexLight" },
    { "where light of vertices is kept",
      [](const Key& k, MarchShader s) { return isLight(s) || k.hasVertexLight(); },
      "texelOfVertex vertexOfTexel" },
    { "rays to lights", followsLight,
      "shadowSourceCount shadowSource lightReach fetchShadowSource "
      "INSIDE_FACE "
      "transmittanceTo" },
    { "march of extinction", followsLight,
      "Tet projectedVertex entersTet ExtinctionMarch marchExtinctionToExit marchExtinction "
      "transmittanceOn "
      "darkDepth "
      "cellExtinction" },
    { "extinction of what is not finite",
      [](const Key& k, MarchShader s) { return followsLight(k, s) && k.NanShown; }, "isFinite" },
    { "extinction along a segment",
      [](const Key& k, MarchShader s) { return followsLight(k, s) && k.PointScalars; },
      "extinctionBetween" },
    { "extinction of a cell",
      [](const Key& k, MarchShader s) { return followsLight(k, s) && !k.PointScalars; },
      "extinctionOf" },
    { "extinction by gradients at vertices",
      [](const Key& k, MarchShader s)
      { return followsLight(k, s) && k.GradientOpacity && k.hasVertexGradients(); },
      "densityAt densityBetween" },
    { "light of a vertex", [](const Key&, MarchShader s) { return isLight(s); },
      "occlusionDirectionCount occlusionRadius vertexStartBuffer fetchVertexStart sphereDirection "
      "lightAtVertex vertexCount" },
  };
  return features;
}
} // namespace tetmarch::testing
