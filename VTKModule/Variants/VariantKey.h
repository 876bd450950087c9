// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The key of the variant of the march shader that a scene needs.
#ifndef TetMarchVariantsVariantKey_h
#define TetMarchVariantsVariantKey_h

#include <array>
#include <cstdint>
#include <string>
#include <variant>

namespace tetmarch
{

/** The group of blend modes. */
enum class BlendGroup : unsigned char
{
  Composite,  // the volume: emission and absorption
  Extreme,    // the maximum or the minimum scalar
  Sum,        // the sum or the average of the scalars
  Isosurfaces // surfaces of constant scalar
};

/** The scalars of a volume. */
enum class ComponentGroup : unsigned char
{
  Single,          // one scalar
  Independent,     // several, each with its own functions, in the same space
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
  bool PointScalars = true; // else one scalar per cell
  bool EntryLists = true;   // entries from lists per pixel; else searched in the hierarchy
  bool Hierarchy = false;   // rays without lists can enter or reenter
  bool OpaqueDepth = false; // rays end at opaque geometry or the far plane
  bool HasFma = true;       // the exact predicate with fused multiply-add; else the portable one
  bool Adaptive = true;     // segments are split until the pixel keeps the error tolerance
  bool Diagnostics = false; // counters in further colour attachments
  bool Peeled = false;      // parts of rays between layers of depth peeling
  bool TransparentRanges = false; // cells of scalars without extinction are skipped
  bool ConstantColor = false;     // everything visible has the same colour

  bool Clipped = false;  // rays begin and end at clipping planes, or at the faces of a cropped box
  bool Cropped = false;  // ranges of rays are left out, region by region
  bool NanShown = false; // cells with a scalar that is not finite have the NaN colour
  bool HiddenCells = false; // some tetrahedra are skipped
  BlendGroup Blend = BlendGroup::Composite;
  ComponentGroup Components = ComponentGroup::Single;

  bool CellGradients = false;    // one per cell; else interpolated between vertices
  bool GradientOpacity = false;  // extinction depends on the gradient
  bool Shading = false;          // lights shine on surfaces of constant scalar
  bool HeadlightOnly = false;    // one light, at the eye, and not in world coordinates
  bool SingleLight = false;      // one light, elsewhere
  bool FewLights = false;        // two to five, for a software renderer
  bool WorldLights = false;      // light is computed in world coordinates: see LightUniforms
  bool Scattering = false;       // the volume scatters light without regard to surfaces
  bool CastShadows = false;      // the volume absorbs light, except that from the eye
  bool SeveralShadows = false;   // shadows of more than one light
  bool SampledShadows = false;   // sampled along each ray; else stored at the vertices
  bool LightTolerance = false;   // light is evaluated at as many points as a tolerance takes
  bool LightThroughCuts = false; // what is clipped away absorbs no light
  bool OpaqueShadows = false;    // opaque geometry casts shadows on the volume, too
  bool HeadlightShadows = false; // the volume absorbs light from the eye
  bool Occlusion = false;        // the volume absorbs ambient light
  bool ShowIllumination = false; // the light without the volume's own colour
  bool ShowGradients = false;    // directions of gradients as colours

  bool Structured = false;   // cells of a lattice, else tetrahedra
  bool Rectilinear = false;  // planes are not evenly spaced
  bool Octree = false;       // cells are leaves of an octree, each of one scalar
  bool Leaps = false;        // rays leap over transparent blocks of cells
  bool PointSampled = false; // the volume is sampled at even distances, not integrated
  bool Slabs = false;        // values are in several textures
  bool ManySlabs = false;    // in more than two

  bool VisiblePart = false; // rays enter and leave a part: what is visible, or all of the mesh
  bool Reentered = false;   // rays leave the mesh and enter it again: their march is in short runs
  bool SplitCells = false;  // tetrahedra are in two texture buffers
  bool CurvedError = false; // the error bound includes the shape of curved cells that were cut
  bool Curvilinear = false; // tetrahedra and links are computed from i, j, k
  bool JoinedSides = false; // points of them coincide: where a ring closes, and at poles
  /** Each corner of a tetrahedron has its own scalar: those of neighbours may differ. */
  bool CornerScalars = false;

  // Derived conditions, by Shaders/derived_conditions.glsl.
  /** Emission and absorption are integrated. */
  bool isComposite() const;
  /** A ray accumulates opacity front to back, so that it may end where it is opaque. */
  bool accumulatesOpacity() const;
  /** The result is known only at the end of a ray. */
  bool isKnownAtEnd() const;
  /** Transfer functions are looked up in tables. */
  bool usesTables() const;
  /** A single table. */
  bool hasOneTable() const;
  /** The first table is that of the opacity. */
  bool hasOpacityTable() const;
  /** Transparent cells are skipped in an inner loop. */
  bool passesCells() const;
  /** Colour and extinction come from different scalars. */
  bool isDependent() const;
  /** More than one scalar is drawn. */
  bool hasComponents() const;
  /** Something depends on the gradient. */
  bool hasGradients() const;
  /** The intervals of cells are gathered in parts in which light changes evenly. */
  bool hasLitParts() const;
  /** Gradients are read from a buffer. */
  bool hasStoredGradients() const;
  /** The colour depends on light or gradients. */
  bool isLit() const;
  bool hasShadows() const;
  /** Light is stored at the vertices. */
  bool hasVertexLight() const;
  /** Ambient light is sampled along each ray. */
  bool samplesOcclusion() const;
  /** Shadows of opaque surfaces are sampled along each ray. */
  bool samplesSurfaces() const;
  /** The error of the integration is bounded along the ray; that of a constant is 0. */
  bool hasErrorBound() const;
  /** Total variations of the transfer functions are read: for error bounds, or for scalars that
   * bend along the ray. */
  bool needsVariations() const;

  bool operator==(const VariantKey& other) const;

  /** The key without features that have no effect, and with those that others imply. */
  VariantKey filtered() const;
  /** The key of a pass that only searches entries: it does not depend on the blend mode. */
  VariantKey ofEntries() const;

  /** The variant that marches from the vertices towards the light: it uses only extinction, and the
   * shadows of opaque geometry. reenters: rays may leave the volume and reenter. */
  VariantKey ofVertexLight(bool reenters) const;

  /** The variant of picks: as in the picture, but without light, up to opaque geometry. */
  VariantKey ofPick() const;

  /** The preprocessor lines that select the variant in the shader text. */
  std::string defines() const;

  struct Feature
  {
    const char* Name;  // symbol without the prefix TETMARCH_
    std::uint64_t Bit; // TETMARCH_WITH_... of Variants/Features.h
    std::variant<bool VariantKey::*, BlendGroup, ComponentGroup> Value;
    bool isOn(const VariantKey& key) const;
    /** A value of a group replaces the previous one; if it is switched off, the group has its first
     * value. */
    void set(VariantKey& key, bool on) const;
  };
  static constexpr int NumberOfFeatures = 52;
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
