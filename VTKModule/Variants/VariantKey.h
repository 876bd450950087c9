// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which variant of the march shader a scene needs.
#ifndef TetMarchVariantsVariantKey_h
#define TetMarchVariantsVariantKey_h

#include <array>
#include <string>

namespace tetmarch
{

/**
 * Each member is a preprocessor symbol of the shader. Values that change without recompiling are
 * uniforms, not bits. Each has a row in bits() and, where it can be irrelevant, a line in
 * filtered().
 */
struct VariantKey
{
  bool PointScalars = true; // else one scalar a cell
  bool RasterEntry =
    true; // entries from the rasterised boundary; else searched for in the hierarchy
  bool Hierarchy = false;   // rays can enter more than once, or are not rasterised
  bool OpaqueDepth = false; // rays end at opaque geometry or the far plane
  bool HasFma = true;       // the exact predicate by fused multiply-add; else the portable one
  bool Adaptive = true;     // segments are split until the pixel keeps the error tolerance
  bool Diagnostics = false; // counters in further colour attachments
  bool Peeled = false; // parts of rays, as a pass that peels translucent geometry asks for them
  bool TransparentRanges = false; // there are scalars without extinction: their cells are passed
  bool ConstantColor = false;     // whatever is seen has the same colour

  bool Clipped = false;  // rays begin and end at clipping planes, or at the faces of a cropped box
  bool Cropped = false;  // and pieces of them are left out, region by region
  bool NanShown = false; // what touches a scalar that is not finite has a colour of its own
  bool HiddenCells = false; // some tetrahedra are passed as if nothing was in them
  bool Extreme = false;     // the greatest or least scalar of a ray is shown
  bool Sum = false;         // sums or averages of the scalars of a ray are shown
  bool Isosurfaces = false; // surfaces of constant scalar are; without these three: the volume

  bool Independent = false;     // several scalars, each with functions of its own, fill one space
  bool ColorAndOpacity = false; // one scalar gives the colour, another the opacity
  bool DirectColor = false;     // three scalars are the colour, a fourth gives the opacity

  bool CellGradients = false;    // that of each cell as it is; else interpolated between vertices
  bool GradientOpacity = false;  // extinction depends on the gradient
  bool Shading = false;          // lights shine on surfaces of constant scalar
  bool HeadlightOnly = false;    // one light, at the eye, and not in world coordinates
  bool SingleLight = false;      // one light, elsewhere
  bool WorldLights = false;      // light is reckoned in world coordinates: see LightUniforms
  bool Scattering = false;       // the volume scatters light without regard to surfaces
  bool CastShadows = false;      // the volume keeps light from itself, but for that from the eye
  bool SeveralShadows = false;   // and more than one light does
  bool SampledShadows = false;   // how much is looked for along each ray; else kept at vertices
  bool OpaqueShadows = false;    // opaque geometry keeps light from the volume, too
  bool HeadlightShadows = false; // the volume keeps light from itself that comes from the eye
  bool Occlusion = false;        // the volume keeps ambient light from its inside
  bool ShowIllumination = false; // the light without the volume's own colour
  bool ShowGradients = false;    // directions of gradients as colours

  /** Emission and absorption are integrated. */
  bool isComposite() const { return !this->Extreme && !this->Sum && !this->Isosurfaces; }
  /** Colour and extinction come from different scalars. */
  bool isDependent() const { return this->ColorAndOpacity || this->DirectColor; }
  /** More than one scalar is drawn. */
  bool hasComponents() const { return this->Independent || this->isDependent(); }
  /** Cells in which nothing is seen are passed in a loop of their own. */
  bool passesCells() const { return this->TransparentRanges || this->Isosurfaces; }
  bool hasGradients() const
  {
    return this->GradientOpacity || this->Shading || this->ShowGradients;
  }
  bool hasShadows() const { return this->CastShadows || this->HeadlightShadows; }
  bool hasVertexGradients() const { return this->hasGradients() && !this->CellGradients; }
  bool hasVertexLight() const
  {
    return this->Occlusion || (this->CastShadows && (!this->SampledShadows || this->OpaqueShadows));
  }
  /** Whether the error of the integration is bounded along the way; that of a constant is 0. */
  bool hasErrorBound() const
  {
    return this->PointScalars && !this->ConstantColor && this->isComposite() &&
           (this->Adaptive || this->Diagnostics);
  }

  bool operator==(const VariantKey& other) const;

  /** The key without bits that change nothing, and with those that others imply. */
  VariantKey filtered() const;
  /** The key of what looks for entries alone; the variant that marches makes no difference. */
  VariantKey ofEntries() const;

  /** The variant that marches from the vertices towards the light: extinction alone, and whatever
   * opaque geometry there is. */
  VariantKey ofVertexLight() const;

  /** The variant that looks where rays are picked: what they gather, but no light, up to whatever
   * else is there. */
  VariantKey ofPick() const;

  /** The preprocessor lines that select the variant in the shader text. */
  std::string defines() const;

  /** Symbol (behind TETMARCH_) and member of each bit. */
  struct Bit
  {
    const char* Name;
    bool VariantKey::*Member;
  };
  static constexpr int NumberOfBits = 35;
  static const std::array<Bit, NumberOfBits>& bits();

private:
  void dropWhatIsNotBlended();
  void dropWhatComponentsLack();
};

} // namespace tetmarch

#endif
