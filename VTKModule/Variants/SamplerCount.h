// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How many textures the shader of a variant reads. OpenGL guarantees 16 in one stage.
#ifndef TetMarchVariantsSamplerCount_h
#define TetMarchVariantsSamplerCount_h

namespace tetmarch
{

struct VariantKey;

/** A pass that peels translucent geometry adds so many of its own to a variant that is peeled. */
constexpr int SamplersOfPeeling = 4;
/** So many are read beside those of the picture where several processes draw it, visit by visit. */
constexpr int SamplersOfVisits = 3;

/** The samplers of the picture's shader, those of a pass that peels included. */
int samplersOf(const VariantKey& key);

/** The key, or where it has more samplers than there are texture units the key of the same picture
 * that takes longer: rays march through what nothing is seen of. */
VariantKey fittedTo(int units, const VariantKey& key);

} // namespace tetmarch

#endif
