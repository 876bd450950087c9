// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which features the shader of a picture has: VTKModule/Variants/VariantKey.cxx, as far as a page
// can change them.

const BLENDED = ["EXTREME", "SUM", "ISOSURFACES"];
const OF_PICKS = [
  "BVH", "STRUCTURED", "RECTILINEAR", "OCTREE", "SLABS", "MANY_SLABS", "LEAPS", "POINT_SCALARS",
  "CLIPPED", "CROPPED", "NAN_SHOWN", "HIDDEN_CELLS", "PACKED_SQUARES", ...BLENDED, "INDEPENDENT",
  "GRADIENT_OPACITY"
];

function isComposite(features)
{
  return !BLENDED.some((name) => features.has(name));
}

function setIf(features, name, on)
{
  on ? features.add(name) : features.delete(name);
}

/**
 * The features of a picture. written: those of the page; level: of levelOf(); traits: of edited
 * tables, or null; entries: { lists, visiblePart }, whether rays enter by lists, and of what.
 */
export function pictureFeatures(written, {level, traits, counts, opaqueDepth, entries})
{
  const features = new Set(written);
  const composite = isComposite(features);
  const structured = features.has("STRUCTURED");
  if (traits)
  {
    const several =
      ["INDEPENDENT", "COLOR_AND_OPACITY", "DIRECT_COLOR"].some((name) => features.has(name));
    const shows = ["SHOW_ILLUMINATION", "SHOW_GRADIENTS"].some((name) => features.has(name));
    features.delete("LEAPS"); // which blocks are empty depends on the functions
    setIf(features, "CONSTANT_COLOR", composite && !several && !shows && traits.constantColor);
    setIf(features, "TRANSPARENT_RANGES",
      composite && !structured && !features.has("INDEPENDENT") && traits.transparentRanges);
  }
  setIf(features, "POINT_SAMPLED", features.has("POINT_SAMPLED") && level.sampled);
  setIf(features, "ADAPTIVE",
    level.adaptive && composite && features.has("POINT_SCALARS") &&
      (structured || !features.has("CONSTANT_COLOR")));
  setIf(features, "DIAGNOSTICS", counts);
  setIf(features, "OPAQUE_DEPTH", opaqueDepth);
  setIf(features, "ENTRY_LISTS", entries.lists);
  setIf(features, "VISIBLE_PART", entries.visiblePart);
  setIf(features, "TRANSPARENT_RANGES", features.has("TRANSPARENT_RANGES") && !entries.visiblePart);
  // Rays of pixels have lists, rays towards the light have none.
  setIf(
    features, "BVH", features.has("BVH") && (!entries.lists || features.has("SAMPLED_SHADOWS")));
  features.delete("HAS_FMA");
  return features;
}

/** The features of a pick: as in the picture, but without light. */
export function pickFeatures(written, traits)
{
  const level = {adaptive: false, sampled: false};
  const entries = {lists: false, visiblePart: false};
  const picture =
    pictureFeatures(written, {level, traits, counts: false, opaqueDepth: true, entries});
  const features = new Set(OF_PICKS.filter((name) => picture.has(name)));
  features.add("OPAQUE_DEPTH");
  setIf(
    features, "CELL_GRADIENTS", features.has("GRADIENT_OPACITY") && picture.has("CELL_GRADIENTS"));
  setIf(features, "ADAPTIVE",
    features.has("STRUCTURED") && features.has("POINT_SCALARS") && isComposite(features));
  return features;
}
