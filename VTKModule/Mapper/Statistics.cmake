# The figures of vtkTetMarchFrameStatistics, from Mapper/statistics.json. A row has
#
#   name           of the figure
#   type           bool, int, double, vtkIdType or vtkTypeInt64
#   default        before the first frame, if it isn't 0 or false
#   least          with greatest, if values are clamped
#   words          true: there is a Get...AsString(), which vtkTetMarchFrameStatistics.cxx has
#   own            true: mappers have no method of that name
#   documentation  lines of the header; a row without it is told of in the row before
include("${CMAKE_CURRENT_LIST_DIR}/Settings.cmake")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/statistics.json")

# Writes vtkTetMarchFrameStatistics.h and vtkTetMarchStatisticsMacros.h into a folder, and Mapper/PrintedStatistics.inc
# into another.
function (tetmarch_statistics_sources header_dir source_dir)
  file(READ "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/statistics.json" figures)
  string(JSON last LENGTH "${figures}")
  math(EXPR last "${last} - 1")
  foreach (part IN ITEMS methods setters members forwarders lines)
    set("${part}" "")
  endforeach ()
  foreach (index RANGE "${last}")
    string(JSON figure GET "${figures}" "${index}")
    foreach (member IN ITEMS name type default least greatest words own documentation)
      tetmarch_json("${member}" "${figure}" "${member}")
    endforeach ()
    if (documentation)
      tetmarch_json_lines(documentation "${figure}" documentation "   * ")
      string(APPEND methods "  //@}\n\n  //@{\n  /**\n${documentation}   */\n")
    endif ()
    string(APPEND methods "  vtkGetMacro(${name}, ${type});\n")
    set(printed "this->${name}")
    set(forwarded "  vtkTetMarchFigureMacro(${name}, ${type}); \\\n")
    if (default STREQUAL "")
      set(default 0)
    endif ()
    if (type STREQUAL "bool")
      string(REGEX REPLACE "^0$" "false" default "${default}")
      set(printed "(this->${name} ? \"Yes\" : \"No\")")
      set(forwarded "  vtkTetMarchFactMacro(${name}); \\\n")
    elseif (words)
      string(APPEND methods "  const char* Get${name}AsString() const;\n")
      set(printed "this->Get${name}AsString()")
      string(APPEND forwarded "  vtkTetMarchFigureMacro(${name}AsString, const char*); \\\n")
    endif ()
    if (least STREQUAL "")
      string(APPEND setters "  vtkSetMacro(${name}, ${type});\n")
    else ()
      string(APPEND setters "  vtkSetClampMacro(${name}, ${type}, ${least}, ${greatest});\n")
    endif ()
    string(APPEND members "  ${type} ${name} = ${default};\n")
    string(APPEND lines "os << indent << \"${name}: \" << ${printed} << \"\\n\";\n")
    if (NOT own)
      string(APPEND forwarders "${forwarded}")
    endif ()
  endforeach ()
  string(REGEX REPLACE "^  //@}\n\n" "" methods "${methods}")
  string(APPEND methods "  //@}")
  # Whoever uses the macro writes its last semicolon.
  string(REGEX REPLACE "; \\\\\n$" "" forwarders "${forwarders}")
  foreach (part IN ITEMS setters members)
    string(REGEX REPLACE "\n$" "" "${part}" "${${part}}")
  endforeach ()
  foreach (header IN ITEMS vtkTetMarchFrameStatistics.h vtkTetMarchStatisticsMacros.h)
    configure_file("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${header}.in" "${header_dir}/${header}" @ONLY)
  endforeach ()
  file(CONFIGURE OUTPUT "${source_dir}/Mapper/PrintedStatistics.inc" CONTENT "${lines}")
endfunction ()
