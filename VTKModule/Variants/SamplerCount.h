// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The number of textures that the shader of a variant reads. OpenGL guarantees 16 in one stage.
#ifndef TetMarchVariantsSamplerCount_h
#define TetMarchVariantsSamplerCount_h

namespace tetmarch
{

struct VariantKey;

/** Number of textures that depth peeling adds to a peeled variant. */
constexpr int SamplersOfPeeling = 4;
/** Number of additional textures if several processes draw the picture. */
constexpr int SamplersOfVisits = 3;
/** The same if lists of rays are traced (PixelTolerance). */
constexpr int SamplersOfRayLists = 3;

/** The samplers of the picture's shader, including those of depth peeling. */
int samplersOf(const VariantKey& key);

/** The key or, if it has more samplers than there are texture units, a slower key of the same
 * picture, whose rays march through transparent cells. */
VariantKey fittedTo(int units, const VariantKey& key);

} // namespace tetmarch

#endif
