// The march of the picture, in the order in which its files use each other.
#include "march/traversal_files.glsl"
#if TETMARCH_LIT || TETMARCH_LIT_COMPONENTS
#include "light/light.glsl"
#endif
#if TETMARCH_CURVED_ERROR
#include "gather/shifted_face.glsl"
#endif
#if TETMARCH_ACCUMULATES_OPACITY
#include "gather/radiance.glsl"
#endif
#if TETMARCH_COMPOSITE
#include "gather/absorption.glsl"
#endif
#if TETMARCH_EFFECTS
#include "light/effect_files.glsl"
#elif TETMARCH_LIT_COMPONENTS
#include "light/component_light_files.glsl"
#endif
#if TETMARCH_BENT
#include "structured/bend.glsl"
#endif
#if TETMARCH_BENT_COMPONENTS && TETMARCH_ERROR_BOUND
#include "structured/component_bend.glsl"
#endif
#include "march/segment.glsl"
#include "march/cell_interval.glsl"
#if TETMARCH_LIGHT_ERROR || TETMARCH_LIT_PARTS
#include "light/light_error.glsl"
#endif
#include "light/cell_shades.glsl"
#include "gather/gather_files.glsl"
#include "cuts/cropping.glsl"
#include "gather/gather_cell.glsl"
#if TETMARCH_PICKED
#include "march/pick_interval.glsl"
#endif
#if TETMARCH_SAMPLED_SHADOWS
#include "light/light_start_files.glsl"
#include "march/sample_pause.glsl"
#endif
#include "march/crossing.glsl"
#if TETMARCH_STRUCTURED
#include "structured/cross_cell.glsl"
#else
#if TETMARCH_CURVED_ERROR
#include "tet/curved_shift.glsl"
#endif
#include "tet/cross_cell.glsl"
#endif
#if TETMARCH_PAUSES_WITHIN
#include "light/gather_to_sample.glsl"
#endif
#if TETMARCH_LIT_PARTS
#include "light/lit_parts.glsl"
#endif
#include "march/march.glsl"
