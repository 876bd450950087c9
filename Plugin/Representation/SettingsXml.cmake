# ParaView's properties of the settings, from VTKModule/Mapper/settings.json. `panel` of a row has
#
#   group              where it is in the panel: the placeholder TETMARCH_<GROUP>_SETTINGS of a template
#   only               "grids" or "images", if it is for one kind of data
#   advanced           true: seen among the advanced properties only
#   text               the lines of its documentation; text_of_images: in the representation of images
#   default_of_images  the value at the start there, if it is another one
#   least              of the slider, where the setting itself has none
#   decorator          what its widget follows: mode, property of ours, value
include("${PROJECT_SOURCE_DIR}/VTKModule/Mapper/Settings.cmake")

set(tetmarch_xml_of_bool Int)
set(tetmarch_xml_of_int Int)
set(tetmarch_xml_of_choice Int)
set(tetmarch_xml_of_float Double)
set(tetmarch_xml_of_double Double)
set(tetmarch_xml_of_double[2] Double)
set(tetmarch_xml_of_vtkIdType IdType)

# The domain of a choice, and the number of its default.
macro (tetmarch_choice_xml)
  string(JSON count LENGTH "${setting}" choices)
  math(EXPR last "${count} - 1")
  set(domain "        <EnumerationDomain name=\"enum\">\n")
  foreach (number RANGE "${last}")
    foreach (member IN ITEMS constant name label only)
      tetmarch_json("choice_${member}" "${setting}" choices "${number}" "${member}")
    endforeach ()
    if (choice_label STREQUAL "")
      string(REGEX REPLACE "([a-z])([A-Z])" "\\1 \\2" choice_label "${choice_name}")
    endif ()
    if (choice_only STREQUAL "" OR choice_only STREQUAL kind)
      string(APPEND domain "          <Entry text=\"${choice_label}\" value=\"${number}\" />\n")
    endif ()
    if (choice_constant STREQUAL default)
      set(default_number "${number}")
    endif ()
  endforeach ()
  string(APPEND domain "        </EnumerationDomain>\n")
  set(default "${default_number}")
endmacro ()

# Sets TETMARCH_SETTINGS and TETMARCH_<GROUP>_SETTINGS for the representation of "grids" or "images".
function (tetmarch_settings_xml kind)
  set(properties "")
  foreach (index RANGE "${tetmarch_last_setting}")
    string(JSON setting GET "${tetmarch_settings}" "${index}")
    tetmarch_json(panel "${setting}" panel)
    tetmarch_json(only "${panel}" only)
    if (panel STREQUAL "" OR NOT only MATCHES "^(${kind})?$")
      continue ()
    endif ()
    foreach (member IN ITEMS name type default least greatest)
      tetmarch_json("${member}" "${setting}" "${member}")
    endforeach ()
    foreach (member IN ITEMS group advanced default_of_images decorator)
      tetmarch_json("${member}" "${panel}" "${member}")
    endforeach ()
    set(elements 1)
    set(domain "")
    if (type STREQUAL "choice")
      tetmarch_choice_xml()
    elseif (type STREQUAL "bool")
      set(domain "        <BooleanDomain name=\"bool\" />\n")
      string(REPLACE "true" "1" default "${default}")
      string(REPLACE "false" "0" default "${default}")
    elseif (NOT type STREQUAL "vtkIdType")
      if (type STREQUAL "double[2]")
        set(elements 2)
        string(JSON low GET "${default}" 0)
        string(JSON high GET "${default}" 1)
        set(default "${low} ${high}")
        tetmarch_json(least "${panel}" least)
      endif ()
      if (NOT greatest STREQUAL "")
        set(greatest " max=\"${greatest}\"")
      endif ()
      set(domain "        <${tetmarch_xml_of_${type}}RangeDomain name=\"range\" min=\"${least}\"${greatest} />\n")
    endif ()
    set(text text)
    if (kind STREQUAL "images")
      string(JSON other ERROR_VARIABLE missing GET "${panel}" text_of_images)
      if (NOT missing)
        set(text text_of_images)
      endif ()
      if (NOT default_of_images STREQUAL "")
        set(default "${default_of_images}")
      endif ()
    endif ()
    tetmarch_json_lines(text "${panel}" "${text}" "          ")
    set(hints "")
    if (decorator)
      foreach (member IN ITEMS mode property value)
        string(JSON "${member}" GET "${decorator}" "${member}")
      endforeach ()
      set(follows "<PropertyWidgetDecorator type=\"GenericDecorator\"
                                   mode=\"${mode}\"
                                   property=\"TetMarch${property}\"
                                   value=\"${value}\" />")
      if (property STREQUAL "Shade")
        # A preset of light shades, too.
        set(follows "<PropertyWidgetDecorator type=\"CompositeDecorator\">
            <Expression type=\"or\">
          ${follows}
          <PropertyWidgetDecorator type=\"GenericDecorator\"
                                   mode=\"${mode}\"
                                   property=\"TetMarchLightPreset\"
                                   value=\"0\"
                                   inverse=\"1\" />
            </Expression>
          </PropertyWidgetDecorator>")
      endif ()
      set(hints "        <Hints>
          ${follows}
        </Hints>\n")
    endif ()
    set(element "${tetmarch_xml_of_${type}}VectorProperty")
    string(APPEND properties "      <${element} name=\"${name}\"
          command=\"Set${name}\"
          number_of_elements=\"${elements}\"
          default_values=\"${default}\"
          override=\"1\">
${domain}        <Documentation>\n${text}        </Documentation>\n${hints}      </${element}>\n")
    set(visibility "")
    if (advanced)
      set(visibility "\n                      panel_visibility=\"advanced\"")
    endif ()
    string(TOUPPER "TETMARCH_${group}_SETTINGS" group)
    string(APPEND "${group}" "            <Property name=\"${name}\"
                      exposed_name=\"TetMarch${name}\"${visibility} />\n")
    set("${group}" "${${group}}" PARENT_SCOPE)
  endforeach ()
  set(TETMARCH_SETTINGS "${properties}" PARENT_SCOPE)
endfunction ()
