# tetmarch-render's options of settings, from VTKModule/Mapper/settings.json. `option` of a row has
#
#   name      with its dashes; value: how the help calls it, if it has one
#   section   where the help has it: the placeholder TETMARCH_<SECTION>_HELP of Help.cxx.in; options of Light have the
#             volume lit
#   least     of the option, if the setting's is another one
#   switches  another setting, of type bool, that the option switches on
#   help      its lines
include("${PROJECT_SOURCE_DIR}/VTKModule/Mapper/Settings.cmake")

# The text of a C++ expression that makes the Option of the present setting.
macro (tetmarch_option_expression)
  set(setter "&vtkTetMarchSettings::Set${name}")
  if (type STREQUAL "choice")
    set(expression "SettingWord({ \"${quoted_words}\" }, ${setter})")
  elseif (type STREQUAL "bool")
    set(expression "SettingSwitch(${setter})")
  elseif (greatest STREQUAL "")
    set(expression "PositiveSetting(${setter})")
  else ()
    set(expression "SettingWithin(\"${least}\", \"${greatest}\", ${setter})")
  endif ()
  if (switches)
    set(expression "Also(&vtkTetMarchSettings::Set${switches}, ${expression})")
  endif ()
  if (section STREQUAL "Light")
    set(expression "Lit(${expression})")
  endif ()
endmacro ()

# Writes SettingOptions.inc, Help.cxx and completion.bash into the build folder.
function (tetmarch_setting_options)
  set(rows "")
  set(TETMARCH_COMPLETED_OPTIONS "")
  set(TETMARCH_COMPLETED_WORDS "")
  set(TETMARCH_COMPLETED_FLAGS "")
  foreach (index RANGE "${tetmarch_last_setting}")
    string(JSON setting GET "${tetmarch_settings}" "${index}")
    tetmarch_json(option "${setting}" option)
    if (option STREQUAL "")
      continue ()
    endif ()
    foreach (member IN ITEMS name type least greatest)
      tetmarch_json("${member}" "${setting}" "${member}")
    endforeach ()
    tetmarch_json(least_of_option "${option}" least)
    if (NOT least_of_option STREQUAL "")
      set(least "${least_of_option}")
    endif ()
    foreach (member IN ITEMS value section switches)
      tetmarch_json("${member}" "${option}" "${member}")
    endforeach ()
    string(JSON dashed GET "${option}" name)

    if (type STREQUAL "choice")
      tetmarch_json_members(words "${setting}" choices word)
      string(REPLACE ";" "\", \"" quoted_words "${words}")
      string(REPLACE ";" " " words "${words}")
      string(APPEND TETMARCH_COMPLETED_WORDS "    ${dashed}) printf '%s\\n' ${words} ;;\n")
    elseif (type STREQUAL "bool")
      string(APPEND TETMARCH_COMPLETED_FLAGS " | ${dashed}")
    endif ()
    string(APPEND TETMARCH_COMPLETED_OPTIONS " ${dashed}")
    tetmarch_option_expression()
    string(APPEND rows "{ \"${dashed}\", ${expression} },\n")

    # What is left of the help has 26 columns behind the indentation.
    string(STRIP "${dashed} ${value}" left)
    string(LENGTH "${left}" width)
    math(EXPR gap "26 - ${width}")
    string(REPEAT " " "${gap}" gap)
    tetmarch_json_lines(lines "${option}" help "                            ")
    string(REGEX REPLACE "^ +" "  ${left}${gap}" lines "${lines}")
    string(TOUPPER "TETMARCH_${section}_HELP" section)
    string(APPEND "${section}" "${lines}")
  endforeach ()
  foreach (text IN ITEMS TETMARCH_COMPLETED_WORDS TETMARCH_DATA_HELP TETMARCH_OPACITY_HELP TETMARCH_LEVEL_HELP
      TETMARCH_ACCURACY_HELP TETMARCH_LIGHT_HELP TETMARCH_VIEW_HELP)
    string(REGEX REPLACE "\n$" "" "${text}" "${${text}}")
  endforeach ()
  file(CONFIGURE OUTPUT SettingOptions.inc CONTENT "${rows}")
  configure_file(Help.cxx.in Help.cxx @ONLY)
  configure_file(completion.bash.in completion.bash @ONLY)
endfunction ()
