// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Derived conditions of a key, evaluated by the same list as in the shaders.
#include "Variants/Features.h"
#include "Variants/VariantKey.h"

namespace tetmarch
{

#define TETMARCH_VARIANT this->bits()

bool VariantKey::isComposite() const { return TETMARCH_COMPOSITE; }
bool VariantKey::accumulatesOpacity() const { return TETMARCH_ACCUMULATES_OPACITY; }
bool VariantKey::isKnownAtEnd() const { return TETMARCH_KNOWN_AT_END; }
bool VariantKey::usesTables() const { return TETMARCH_USES_TABLES; }
bool VariantKey::hasOneTable() const { return TETMARCH_ONE_TABLE; }
bool VariantKey::hasOpacityTable() const { return TETMARCH_OPACITY_TABLE; }
bool VariantKey::passesCells() const { return TETMARCH_PASSES_CELLS; }
bool VariantKey::isDependent() const { return TETMARCH_DEPENDENT; }
bool VariantKey::hasComponents() const { return TETMARCH_COMPONENTS; }
bool VariantKey::hasGradients() const { return TETMARCH_EFFECTS; }
bool VariantKey::hasLitParts() const { return TETMARCH_LIT_PARTS; }
bool VariantKey::hasStoredGradients() const { return TETMARCH_STORED_GRADIENTS; }
bool VariantKey::isLit() const { return TETMARCH_LIT; }
bool VariantKey::hasShadows() const { return TETMARCH_SHADOWS; }
bool VariantKey::hasVertexLight() const { return TETMARCH_VERTEX_LIGHT; }
bool VariantKey::samplesOcclusion() const { return TETMARCH_SAMPLED_OCCLUSION; }
bool VariantKey::samplesSurfaces() const { return TETMARCH_SAMPLED_SURFACES; }
bool VariantKey::hasErrorBound() const { return TETMARCH_ERROR_BOUND; }
bool VariantKey::needsVariations() const { return TETMARCH_VARIATIONS; }

} // namespace tetmarch
