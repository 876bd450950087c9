// The march of the picture, in the order in which its files use each other.
#include "tet/traversal_files.glsl"
#if TETMARCH_LIT
#include "light/light.glsl"
#endif
#if TETMARCH_COMPOSITE || TETMARCH_ISOSURFACES
#include "gather/radiance.glsl"
#endif
#if TETMARCH_COMPOSITE
#include "gather/absorption.glsl"
#endif
#if TETMARCH_EFFECTS
#include "light/effect_files.glsl"
#endif
#include "tet/cell_interval.glsl"
#include "gather/gather_files.glsl"
#if TETMARCH_SAMPLED_SHADOWS
#include "tet/tet.glsl"
#endif
#if TETMARCH_CROPPED
#include "cuts/cropping.glsl"
#endif
#if TETMARCH_PICKED
#include "march/pick_segment.glsl"
#endif
#include "march/march.glsl"
