// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShaderFeatures.h"

namespace tetmarch::testing
{
namespace
{
using Key = VariantKey;

bool isTrilinear(const Key& key) { return key.Structured && key.PointScalars; }

/// Shades are found where something is seen, and not at each face.
bool findsShades(const Key& key) { return key.passesCells() || key.Structured; }

bool hasAttributes(const Key& key)
{
  return key.hasVertexGradients() || key.hasVertexLight() ||
         (key.hasComponents() && key.PointScalars && !key.Structured);
}
} // namespace

std::vector<ShaderFeature> featuresOfLight()
{
  return {
    // Gradients.
    { "gradients of a mesh",
      [](const Key& k, MarchShader) { return k.hasGradients() && !k.Structured; },
      "gradientBuffer" },
    { "gradients of a lattice",
      [](const Key& k, MarchShader) { return k.hasGradients() && k.Structured; },
      "gradientFromLattice latticeGradientAt" },
    { "gradients of cells of a lattice by their neighbours",
      [](const Key& k, MarchShader)
      { return k.hasGradients() && isTrilinear(k) && !k.CellGradients; },
      "perDistances perLow perHigh fetchBeside innerCell" },
    { "values beside a cell",
      [](const Key& k, MarchShader)
      { return k.hasGradients() && k.Structured && !k.CellGradients; },
      "finiteOr" },
    { "gradients of trilinear cells",
      [](const Key& k, MarchShader) { return k.hasGradients() && isTrilinear(k); }, "bilinear" },
    { "shades", [](const Key& k, MarchShader s) { return gathers(k, s) && k.hasGradients(); },
      "Shade CellShades FacePoint shadeOf shades incomingAt fractionOfCell "
      "rangeWithin" },
    { "shades where rays leave cells",
      [](const Key& k, MarchShader s)
      { return gathers(k, s) && k.hasGradients() && !k.PointSampled; },
      "leavePoint" },
    { "gradients at vertices",
      [](const Key& k, MarchShader) { return k.hasVertexGradients() && !k.Structured; },
      "fetchGradient" },
    { "shades where rays enter cells",
      [](const Key& k, MarchShader s)
      {
        return gathers(k, s) && k.hasGradients() && (!k.hasVertexGradients() || findsShades(k)) &&
               !k.PointSampled;
      },
      "enterPoint" },
    { "shades at faces",
      [](const Key& k, MarchShader s) { return gathers(k, s) && k.hasVertexGradients(); },
      "shadeAtFace" },
    { "shades where something is seen",
      [](const Key& k, MarchShader s)
      { return gathers(k, s) && k.hasVertexGradients() && findsShades(k); },
      "enterKnown" },
    { "shades at the ends of what is seen",
      [](const Key& k, MarchShader s)
      { return gathers(k, s) && k.hasVertexGradients() && findsShades(k) && !k.PointSampled; },
      "missing" },
    { "shade of the face before",
      [](const Key& k, MarchShader s)
      { return gathers(k, s) && k.hasVertexGradients() && !findsShades(k); },
      "beginShades" },
    { "gradients of tetrahedra",
      [](const Key& k, MarchShader) { return k.CellGradients && !k.Structured; },
      "fetchCellGradient" },
    { "attributes", [](const Key& k, MarchShader) { return hasAttributes(k); },
      "VertexAttributes attributesAt" },
    { "attributes of vertices",
      [](const Key& k, MarchShader) { return hasAttributes(k) && !k.Structured; },
      "fetchAttributes selectAttributes interpolateAttributes attributesA attributesB attributesC "
      "barycentricsOf" },
    { "attributes of vertices along the ray",
      [](const Key& k, MarchShader s)
      { return gathers(k, s) && hasAttributes(k) && !k.Structured; },
      "enterAttributes leaveAttributes" },
    { "opacity by gradients", [](const Key& k, MarchShader) { return k.GradientOpacity; },
      "gradientOpacityBuffer gradientOpacitySize gradientOpacityScale fetchGradientOpacity "
      "gradientOpacity" },
    { "density of shades",
      [](const Key& k, MarchShader s) { return gathers(k, s) && k.GradientOpacity; },
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
      {
        return k.isLit() &&
               (k.hasErrorBound() || (k.Diagnostics && k.isComposite() && !k.PointSampled));
      },
      "greatest" },
    { "brightness",
      [](const Key& k, MarchShader) { return k.isLit() && (k.hasErrorBound() || hasStepError(k)); },
      "brightness bright" },
    { "change of light",
      [](const Key& k, MarchShader)
      { return k.isLit() && k.Diagnostics && k.isComposite() && !k.PointSampled; },
      "lightError changeOf lightErrorOf" },
    { "error of light between vertices",
      [](const Key& k, MarchShader)
      { return k.isLit() && k.Diagnostics && k.hasVertexLight() && !k.Structured; },
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
      "jitter keepPending addPending SamplePause noPause pause due nextSample "
      "sampleLight marchAndSample castSampledRay seenFraction seenDepth SAMPLE_SPACING "
      "FIRST_SAMPLE" },
    { "offsets of pixels",
      [](const Key& k, MarchShader) { return k.SampledShadows || k.PointSampled; },
      "jitterTexture" },
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
      "shadowSourceCount shadowSource lightReach fetchShadowSource LightStart transmittanceTo" },
    { "march of extinction",
      [](const Key& k, MarchShader s) { return k.SampledShadows || (isLight(s) && !k.Structured); },
      "darkDepth cellExtinction" },
    { "rays to lights from samples", [](const Key& k, MarchShader) { return k.SampledShadows; },
      "startIn" },
    { "light of a vertex", [](const Key&, MarchShader s) { return isLight(s); },
      "occlusionDirectionCount occlusionRadius sphereDirection startsAtVertex lightAtVertex "
      "vertexCount" },
  };
}
} // namespace tetmarch::testing
