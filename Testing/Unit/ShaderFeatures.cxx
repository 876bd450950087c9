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

bool isLit(const Key& key) { return key.Shading || key.ShowGradients; }
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
      "isOpaque "
      "marchToExit "
      "marchOn" },
    { "composites", [](const Key& k, MarchShader s) { return gathers(s) && k.isComposite(); },
      "Absorption absorption absorb" },
    { "composites of volumes or surfaces",
      [](const Key& k, MarchShader s) { return gathers(s) && (k.isComposite() || k.Isosurfaces); },
      "emission" },
    { "tolerance", [](const Key& k, MarchShader) { return k.isComposite() || k.Isosurfaces; },
      "errorTolerance" },
    { "segments of the picture",
      [](const Key& k, MarchShader s) { return gathers(s) && k.PointScalars && k.isComposite(); },
      "integrateSegment" },
    { "cells of the picture",
      [](const Key& k, MarchShader s) { return gathers(s) && !k.PointScalars && k.isComposite(); },
      "integrateConstant" },
    { "tables", [](const Key& k, MarchShader) { return !k.Isosurfaces; },
      "tableValueBuffer tableIntegralBuffer "
      "fetchTableValue fetchTableIntegral TablePoint tableBin tableValue tablePoint linearMean "
      "meanBetween" },
    { "one table", [](const Key& k, MarchShader) { return !k.Isosurfaces && !k.hasComponents(); },
      "tableSize tableIntegralUnit" },
    { "table of the first scalar",
      [](const Key& k, MarchShader) { return !k.Isosurfaces && !k.Independent; },
      "tableScale tableOffset" },
    { "components", [](const Key& k, MarchShader) { return k.hasComponents(); },
      "furtherScalarBuffer fetchFurtherScalars TableSpan tableSpan tableFirst tableSizes "
      "tableIntegralUnits tablePlace fetchTableFirst fetchTableSize fetchTableIntegralUnit "
      "fetchTablePlace" },
    { "components of points",
      [](const Key& k, MarchShader) { return k.hasComponents() && k.PointScalars; },
      "furtherA furtherB furtherC furtherAt furtherEnter furtherLeave" },
    { "components along pieces",
      [](const Key& k, MarchShader s) { return gathers(s) && k.hasComponents() && k.PointScalars; },
      "furtherBetween furtherEnd" },
    { "independent components", [](const Key& k, MarchShader) { return k.Independent; },
      "componentCount componentFactor scalarsOf componentOf" },
    { "independent components of points",
      [](const Key& k, MarchShader) { return k.Independent && k.PointScalars; },
      "IndependentMean independentMeanBetween" },
    { "independent components of cells",
      [](const Key& k, MarchShader) { return k.Independent && !k.PointScalars; },
      "independentMeanAt" },
    { "dependent components", [](const Key& k, MarchShader) { return k.isDependent(); },
      "withDependentColor" },
    { "dependent components of points",
      [](const Key& k, MarchShader) { return k.isDependent() && k.PointScalars; },
      "DependentColor dependentColorBetween" },
    { "dependent components of cells",
      [](const Key& k, MarchShader) { return k.isDependent() && !k.PointScalars; },
      "dependentColorOf" },
    { "extreme scalars", [](const Key& k, MarchShader) { return k.Extreme; },
      "extremeSign extreme" },
    { "sums of scalars", [](const Key& k, MarchShader) { return k.Sum; },
      "averages averageRange counted" },
    { "surfaces", [](const Key& k, MarchShader) { return k.Isosurfaces; },
      "isoSurfaceCount isoValue isoColor fetchIsoValue fetchIsoColor valuesReached crossesSurface "
      "drawn" },
    { "light on surfaces", [](const Key& k, MarchShader) { return k.Isosurfaces && isLit(k); },
      "shareOfSurface" },
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
      "tableVariationBuffer variation orderErrorFactor" },
    { "error bound of one scalar",
      [](const Key& k, MarchShader) { return k.hasErrorBound() && !k.hasComponents(); },
      "fetchTableVariation subsegmentError" },
    { "error bound of several",
      [](const Key& k, MarchShader) { return k.hasErrorBound() && k.hasComponents(); },
      "fetchTableVariations extinctionVariation" },
    { "error bound of independent components",
      [](const Key& k, MarchShader) { return k.hasErrorBound() && k.Independent; }, "greatestOf" },
    { "error bound of dependent components",
      [](const Key& k, MarchShader) { return k.hasErrorBound() && k.isDependent(); },
      "dependentError" },
    { "adaptive", [](const Key& k, MarchShader) { return k.Adaptive; },
      "mostTrials errorBudget TOLERANCE_AT_ONCE TOLERANCE_BY_ABSORPTION budget" },
    { "diagnostics", [](const Key& k, MarchShader) { return k.Diagnostics; },
      "lookups lost guarded met" },
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
      "nextPlane planesBelow isLeft nextSegment rest cropping" },
    { "rays of pixels", [](const Key&, MarchShader s) { return !isLight(s); }, "viewport eye" },
    { "one march a ray",
      [](const Key& k, MarchShader s)
      { return (isPicture(s) && !k.SampledShadows) || (isPick(s) && (k.Extreme || k.Sum)); },
      "castPlainRay" },
    { "pick", [](const Key&, MarchShader s) { return isPick(s); },
      "Pick PICK_STEPS noPick isPicked gathered gatheredUpTo pickSegment pickOn "
      "transmittanceLeft" },
    { "pick of scalars",
      [](const Key& k, MarchShader s) { return isPick(s) && (k.Extreme || k.Sum); },
      "PICK_ROUNDING" },
    // Gradients.
    { "gradients", [](const Key& k, MarchShader) { return k.hasGradients(); }, "gradientBuffer" },
    { "shades", [](const Key& k, MarchShader s) { return gathers(s) && k.hasGradients(); },
      "Shade CellShades FacePoint shadeOf mixShade facePoint beginShades beginCell shadeCell "
      "incomingAt shadeWithin shareOf" },
    { "gradients at vertices", [](const Key& k, MarchShader) { return k.hasVertexGradients(); },
      "fetchGradient gradientA gradientB gradientC gradientAt" },
    { "shades at faces",
      [](const Key& k, MarchShader s) { return gathers(s) && k.hasVertexGradients(); },
      "shadeAtFace" },
    { "shades where something is seen",
      [](const Key& k, MarchShader s)
      { return gathers(s) && k.hasVertexGradients() && k.passesCells(); },
      "enterKnown missing" },
    { "gradients of cells", [](const Key& k, MarchShader) { return k.CellGradients; },
      "fetchCellGradient" },
    { "values at corners",
      [](const Key& k, MarchShader) {
        return k.hasVertexGradients() || k.hasVertexLight() ||
               (k.hasComponents() && k.PointScalars);
      },
      "fetchCorners barycentricsOf" },
    { "opacity by gradients", [](const Key& k, MarchShader) { return k.GradientOpacity; },
      "gradientOpacityBuffer gradientOpacitySize gradientOpacityScale fetchGradientOpacity "
      "gradientOpacity" },
    { "density of shades",
      [](const Key& k, MarchShader s) { return gathers(s) && k.GradientOpacity; }, "density" },
    { "gradients shown", [](const Key& k, MarchShader) { return k.ShowGradients; },
      "gradientColor" },
    // Light.
    { "light", [](const Key& k, MarchShader) { return isLit(k); },
      "Light Illumination lit direct diffuse specular noLight addLight dimLight mixLight "
      "noIllumination mixIllumination reflection" },
    { "light of pieces", [](const Key& k, MarchShader) { return isLit(k) && k.isComposite(); },
      "litEmission" },
    { "error of light",
      [](const Key& k, MarchShader)
      { return isLit(k) && (k.hasErrorBound() || (k.Diagnostics && k.isComposite())); },
      "greatest" },
    { "brightness", [](const Key& k, MarchShader) { return isLit(k) && k.hasErrorBound(); },
      "brightness bright" },
    { "change of light",
      [](const Key& k, MarchShader) { return isLit(k) && k.Diagnostics && k.isComposite(); },
      "lightError changeOf lightErrorOf" },
    { "error of light between vertices",
      [](const Key& k, MarchShader) { return isLit(k) && k.Diagnostics && k.hasVertexLight(); },
      "unsure unsureLight" },
    { "shading", [](const Key& k, MarchShader) { return k.Shading; },
      "twoSided ambientColor specularPower lightDiffuse lightSpecular fetchLightDiffuse "
      "fetchLightSpecular toEye lightTowards LIGHT_COUNT diffuseOf specularOf illuminate" },
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
      "scatteringBlending gradientUnit scatteredShare scattered" },
    { "shadows", [](const Key& k, MarchShader) { return k.hasShadows(); },
      "shadowStrength shadowChannel fetchShadowStrength fetchShadowChannel addShadowed" },
    { "shadows of headlights", [](const Key& k, MarchShader) { return k.HeadlightShadows; },
      "head" },
    { "sampled shadows", [](const Key& k, MarchShader) { return k.SampledShadows; },
      "jitterTexture jitter keepPending addPending paused nextSample sampleLight "
      "marchAndSample castSampledRay seenShare seenDepth SAMPLED_SHARE FIRST_SAMPLE" },
    { "light past the volume or opaque geometry",
      [](const Key& k, MarchShader s)
      { return isPicture(s) && k.CastShadows && (!k.SampledShadows || k.OpaqueShadows); },
      "incomingFrom" },
    { "shadows of opaque geometry",
      [](const Key& k, MarchShader s) { return isLight(s) && k.OpaqueShadows; },
      "opaqueShadowBuffer fetchOpaqueShadows isShadowed" },
    { "light kept at vertices", [](const Key& k, MarchShader) { return k.hasVertexLight(); },
      "vertexLightTexture fetchVertexLight lightA lightB lightC" },
    { "where light of vertices is kept",
      [](const Key& k, MarchShader s) { return isLight(s) || k.hasVertexLight(); },
      "texelOfVertex vertexOfTexel" },
    { "rays to lights", followsLight,
      "shadowSourceCount shadowSource lightReach fetchShadowSource thicknessPerDepthAlong "
      "INSIDE_FACE "
      "transmittanceTowards" },
    { "march of extinction", followsLight,
      "Tet seenAt entersTet ExtinctionMarch marchExtinctionToExit marchExtinction transmittanceOn "
      "darkDepth "
      "countedExtinction" },
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
