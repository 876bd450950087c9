# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
# Completion of tetmarch-render for bash: options, and values where they are known.

_tetmarch_render_options="--accuracy --ambient --array --association --axes --background --big-endian --blend --camera
  --check --clip --colors --compare --component --crop --crop-regions --diffuse --dimensions --error --frame-time --frames
  --gradient-opacity --help --interpolation --isovalues --jitter --light --list --nan --occlusion --opacity-law
  --opaque-shadows --outline --output --parallel-scale --pixel --pixel-json --preset --quiet --range --reach
  --sample-distance --scalar-bar --scattering --shade --shadows --size --spacing --specular --specular-power --stats
  --surface --threads --tile-size --time --time-step --tolerance --turntable --type --unit-distance --version --view"

# The values of an option, one a line.
_tetmarch_render_values() {
  case $1 in
    --accuracy) printf '%s\n' fast default accurate reference sampled ;;
    --association) printf '%s\n' points cells ;;
    --background) printf '%s\n' none ;;
    --blend) printf '%s\n' composite maximum minimum average additive isosurface ;;
    --colors) tetmarch-render --colors list 2>/dev/null; printf '%s\n' list ;;
    --component) printf '%s\n' magnitude ;;
    --crop-regions) printf '%s\n' middle fence inverted-fence cross inverted-cross ;;
    --interpolation) printf '%s\n' nearest linear ;;
    --light) printf '%s\n' headlight ;;
    --opacity-law) printf '%s\n' structured unstructured ;;
    --shadows) printf '%s\n' off automatic vertices rays ;;
    --time) printf '%s\n' all ;;
    --type) printf '%s\n' uint8 int8 uint16 int16 uint32 int32 uint64 int64 float double ;;
    --view) printf '%s\n' picture error cells lookups illumination gradients faces coordinates ;;
  esac
}

_tetmarch_render() {
  local word=$2 option=$3 value
  COMPREPLY=()
  if [[ $word == = ]]; then # of --option=VALUE, with nothing behind the sign yet
    word=
  elif [[ $option == = ]]; then
    option=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  case $option in
    --output | --pixel-json | --preset | --stats | --surface)
      mapfile -t COMPREPLY < <(compgen -f -- "$word")
      return
      ;;
    --axes | --big-endian | --check | --compare | --jitter | --list | --opaque-shadows | --outline | --quiet) ;;
    --scalar-bar | --shade | --help | --version) ;;
    --*)
      while IFS= read -r value; do
        [[ ${value,,} == "${word,,}"* ]] && COMPREPLY+=("$value")
      done < <(_tetmarch_render_values "$option")
      return
      ;;
  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$_tetmarch_render_options" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}

complete -o filenames -F _tetmarch_render tetmarch-render
