// The common part of all marches: the traversal of the volume, and the transfer functions.
#if TETMARCH_COUNTS_TURNS
#include "march/loop_turns.glsl"
#endif
#if TETMARCH_STRUCTURED
#include "structured/traversal_files.glsl"
#else
#include "tet/traversal_files.glsl"
#endif
#if TETMARCH_USES_TABLES
#include "tables/integral_table.glsl"
#if TETMARCH_READS_BOTH_ENDS
#include "tables/interval_mean.glsl"
#else
#include "tables/table_points.glsl"
#endif
#if TETMARCH_EVEN_CUTS
#include "tables/mean_by_difference.glsl"
#endif
#if TETMARCH_TABLE_ERROR
#include "tables/integral_steps.glsl"
#endif
#endif
#if TETMARCH_GRADIENT_OPACITY
#include "tables/gradient_opacity.glsl"
#endif
