// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which variant of the march shader a scene needs.
#ifndef TetMarchVariantsVariantKey_h
#define TetMarchVariantsVariantKey_h

#include <array>
#include <cstdint>
#include <string>
#include <variant>

namespace tetmarch
{

/** What a ray gathers: one of these. */
enum class BlendGroup : unsigned char
{
  Composite,  // the volume: emission and absorption
  Extreme,    // the greatest or the least scalar
  Sum,        // the sum or the average of the scalars
  Isosurfaces // surfaces of constant scalar
};

/** Which scalars a volume has: one of these. */
enum class ComponentGroup : unsigned char
{
  Single,          // one scalar
  Independent,     // several, each with functions of its own, fill one space
  ColorAndOpacity, // one gives the colour, another the opacity
  DirectColor      // three are the colour, a fourth gives the opacity
};

/**
 * Each feature is a preprocessor symbol of the shader: a member, or a value of a group. Values that
 * change without recompiling are uniforms, not features. Each has a line in Variants/features.txt
 * and, where it can be irrelevant, one in filtered().
 */
struct VariantKey
{
  bool PointScalars = true; // else one scalar a cell
  bool EntryLists = true;   // entries from lists by pixels; else searched for in the hierarchy
  bool Hierarchy = false;   // rays that have no list can enter, or enter again
  bool OpaqueDepth = false; // rays end at opaque geometry or the far plane
  bool HasFma = true;       // the exact predicate by fused multiply-add; else the portable one
  bool Adaptive = true;     // segments are split until the pixel keeps the error tolerance
  bool Diagnostics = false; // counters in further colour attachments
  bool Peeled = false; // parts of rays, as a pass that peels translucent geometry asks for them
  bool TransparentRanges = false; // there are scalars without extinction: their cells are passed
  bool ConstantColor = false;     // whatever is seen has the same colour

  bool Clipped = false;  // rays begin and end at clipping planes, or at the faces of a cropped box
  bool Cropped = false;  // and ranges of them are left out, region by region
  bool NanShown = false; // what touches a scalar that is not finite has a colour of its own
  bool HiddenCells = false; // some tetrahedra are passed as if nothing was in them
  BlendGroup Blend = BlendGroup::Composite;
  ComponentGroup Components = ComponentGroup::Single;

  bool CellGradients = false;   // that of each cell as it is; else interpolated between vertices
  bool GradientOpacity = false; // extinction depends on the gradient
  bool Shading = false;         // lights shine on surfaces of constant scalar
  bool HeadlightOnly = false;   // one light, at the eye, and not in world coordinates
  bool SingleLight = false;     // one light, elsewhere
  bool WorldLights = false;     // light is computed in world coordinates: see LightUniforms
  bool Scattering = false;      // the volume scatters light without regard to surfaces
  bool CastShadows = false; // the volume absorbs the light that it gets, but for that from the eye
  bool SeveralShadows = false;   // that of more than one light
  bool SampledShadows = false;   // sampled along each ray; else it is kept at the vertices
  bool OpaqueShadows = false;    // opaque geometry casts shadows on the volume, too
  bool HeadlightShadows = false; // the volume absorbs light from the eye
  bool Occlusion = false;        // the volume absorbs ambient light
  bool ShowIllumination = false; // the light without the volume's own colour
  bool ShowGradients = false;    // directions of gradients as colours

  bool Structured = false;   // the cells are those of a lattice, else tetrahedra
  bool Rectilinear = false;  // whose planes are not evenly spaced
  bool Leaps = false;        // rays leap over blocks of cells of which nothing can be seen
  bool PointSampled = false; // the volume is sampled at even distances, not integrated
  bool Slabs = false;        // the values lie in several textures
  bool ManySlabs = false;    // more than two

  bool VisiblePart =
    false;                 // rays enter and leave those tetrahedra alone of which something is seen
  bool SplitCells = false; // the tetrahedra lie in two texture buffers

  // What follows from these, by Shaders/derived_conditions.glsl.
  /** Emission and absorption are integrated. */
  bool isComposite() const;
  /** A ray gathers opacity front to back, so that it may end where it is opaque. */
  bool accumulatesOpacity() const;
  /** What is shown is known only at the end of a ray. */
  bool isKnownAtEnd() const;
  /** Transfer functions are looked up in tables. */
  bool usesTables() const;
  /** A single one. */
  bool hasOneTable() const;
  /** The first table is that of the opacity. */
  bool hasOpacityTable() const;
  /** Cells in which nothing is seen are passed in a loop of their own. */
  bool passesCells() const;
  /** Colour and extinction come from different scalars. */
  bool isDependent() const;
  /** More than one scalar is drawn. */
  bool hasComponents() const;
  /** Something depends on the gradient. */
  bool hasGradients() const;
  bool hasVertexGradients() const;
  /** Light, or the colour of gradients, makes what is seen. */
  bool isLit() const;
  bool hasShadows() const;
  /** Light is kept at the vertices. */
  bool hasVertexLight() const;
  /** The error of the integration is bounded along the ray; that of a constant is 0. */
  bool hasErrorBound() const;
  /** Total variations of the transfer functions are read: for error bounds, or for scalars that
   * bend along the ray. */
  bool needsVariations() const;

  bool operator==(const VariantKey& other) const;

  /** The key without features that change nothing, and with those that others imply. */
  VariantKey filtered() const;
  /** The key of a pass that searches entries alone: it does not depend on what is gathered. */
  VariantKey ofEntries() const;

  /** The variant that marches from the vertices towards the light: it knows extinction alone, and
   * the shadows of opaque geometry. reenters: rays may leave the volume and enter it again. */
  VariantKey ofVertexLight(bool reenters) const;

  /** The variant that finds where rays are picked: they gather as in the picture, but without
   * light, up to opaque geometry. */
  VariantKey ofPick() const;

  /** The preprocessor lines that select the variant in the shader text. */
  std::string defines() const;

  struct Feature
  {
    const char* Name;  // symbol, behind TETMARCH_
    std::uint64_t Bit; // TETMARCH_WITH_... of Variants/Features.h
    std::variant<bool VariantKey::*, BlendGroup, ComponentGroup> Value;
    bool isOn(const VariantKey& key) const;
    /** A value of a group takes the place of the one there was; where it is switched off, the
     * group's first value takes its place. */
    void set(VariantKey& key, bool on) const;
  };
  static constexpr int NumberOfFeatures = 43;
  static const std::array<Feature, NumberOfFeatures>& features();
  /** The bits of all features that are on. */
  std::uint64_t bits() const;

private:
  void dropWhatLatticesLack();
  void dropWhatIsNotBlended();
  void dropWhatComponentsLack();
};

} // namespace tetmarch

#endif
