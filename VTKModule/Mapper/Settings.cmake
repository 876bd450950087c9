# The settings of a mapper, from Mapper/settings.json. A row has
#
#   name           of the property
#   type           bool, int, double, float, vtkIdType, double[2], or choice
#   default        the value at the start; of a choice the constant
#   least          if numbers are clamped; greatest: no limit without it
#   enumeration    of a choice: the type of its constants
#   choices        constant; name: in methods and texts; word: of tetmarch-render and in sessions; label: ParaView's, if
#                  it isn't the name with spaces; only: "grids" or "images", if it is for one kind of data
#   documentation  lines of the header; a row without it is told of in the row before
#   inherited      true: vtkSmartVolumeMapper has methods of that name, so vtkTetMarchSmartVolumeMapper overrides them
#   panel          of ParaView's property, if there is one: see Plugin/Representation/SettingsXml.cmake
#   session        of tetmarch-view: see Tools/View/SettingsState.cmake
#   option         of tetmarch-render, if there is one: see Tools/Render/SettingOptions.cmake
#
# Numbers are texts: CMake's JSON would print 0.1 as 0.10000000000000001.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/settings.json")
file(READ "${CMAKE_CURRENT_LIST_DIR}/settings.json" tetmarch_settings)
string(JSON tetmarch_last_setting LENGTH "${tetmarch_settings}")
math(EXPR tetmarch_last_setting "${tetmarch_last_setting} - 1")

# What stands in an object of JSON at a path; empty if nothing does.
function (tetmarch_json result object)
  string(JSON value ERROR_VARIABLE missing GET "${object}" ${ARGN})
  if (missing)
    set(value "")
  endif ()
  set("${result}" "${value}" PARENT_SCOPE)
endfunction ()

# The strings of an array, each with a text before it, a line each.
function (tetmarch_json_lines result object member before)
  set(lines "")
  string(JSON count LENGTH "${object}" "${member}")
  math(EXPR last "${count} - 1")
  foreach (index RANGE "${last}")
    string(JSON line GET "${object}" "${member}" "${index}")
    string(APPEND lines "${before}${line}\n")
  endforeach ()
  string(REGEX REPLACE " +\n" "\n" lines "${lines}")
  set("${result}" "${lines}" PARENT_SCOPE)
endfunction ()

# A list of what the objects of an array have as a member.
function (tetmarch_json_members result object array member)
  set(values)
  string(JSON count LENGTH "${object}" "${array}")
  math(EXPR last "${count} - 1")
  foreach (index RANGE "${last}")
    string(JSON value GET "${object}" "${array}" "${index}" "${member}")
    list(APPEND values "${value}")
  endforeach ()
  set("${result}" "${values}" PARENT_SCOPE)
endfunction ()

# What the C++ has of a choice: it appends to the texts of the function below.
macro (tetmarch_choice_sources)
  tetmarch_json(enumeration "${setting}" enumeration)
  string(JSON count LENGTH "${setting}" choices)
  math(EXPR last "${count} - 1")
  set(constants "")
  set(forwarded "")
  set(setters "")
  set(names "")
  foreach (number RANGE "${last}")
    string(JSON constant GET "${setting}" choices "${number}" constant)
    string(JSON name_of_choice GET "${setting}" choices "${number}" name)
    set(comma ",")
    if (number EQUAL last)
      set(comma "")
    endif ()
    string(APPEND constants "    ${constant} = ${number}${comma}\n")
    string(APPEND forwarded "    ${constant} = vtkTetMarchSettings::${constant}${comma} \\\n")
    string(APPEND setters "  void Set${name}To${name_of_choice}() { this->Set${name}(${constant}); }\n")
    string(APPEND names "    \"${name_of_choice}\"${comma}\n")
    string(APPEND to_choices "  vtkTetMarchForwardChoiceToMacro(${name}, ${name_of_choice}); \\\n")
  endforeach ()
  string(JSON first GET "${setting}" choices 0 constant)
  string(APPEND methods "  enum ${enumeration}\n  {\n${constants}  };\n"
    "  vtkSetClampMacro(${name}, int, ${first}, ${constant});\n  vtkGetMacro(${name}, int);\n"
    "${setters}  const char* Get${name}AsString() const;\n")
  string(APPEND members "  int ${name} = ${default};\n")
  string(APPEND enums "  enum ${enumeration} \\\n  { \\\n${forwarded}  }; \\\n")
  string(APPEND as_strings "//------------------------------------------------------------------------------\n"
    "const char* vtkTetMarchSettings::Get${name}AsString() const\n{\n"
    "  constexpr const char* names[] = {\n${names}  };\n  return names[this->${name}];\n}\n\n")
endmacro ()

# Writes vtkTetMarchSettings.h and vtkTetMarchSettingsMacros.h into a folder, vtkTetMarchSettings.cxx into another.
function (tetmarch_settings_sources header_dir source_dir)
  set(most_of_double VTK_DOUBLE_MAX)
  set(most_of_vtkIdType VTK_ID_MAX)
  foreach (part IN ITEMS methods members enums as_strings lines own_forwarders inherited_forwarders)
    set("${part}" "")
  endforeach ()
  foreach (index RANGE "${tetmarch_last_setting}")
    string(JSON setting GET "${tetmarch_settings}" "${index}")
    foreach (member IN ITEMS name type default least greatest documentation inherited)
      tetmarch_json("${member}" "${setting}" "${member}")
    endforeach ()
    if (documentation)
      tetmarch_json_lines(documentation "${setting}" documentation "   * ")
      string(APPEND methods "  //@}\n\n  //@{\n  /**\n${documentation}   */\n")
    endif ()
    set(to_choices "")
    set(printed "this->${name}")
    set(forwarder "vtkTetMarchForwardClampedMacro(${name}, ${type})")
    if (type STREQUAL "choice")
      tetmarch_choice_sources()
      set(printed "this->Get${name}AsString()")
      set(forwarder "vtkTetMarchForwardChoiceMacro(${name})")
    elseif (type STREQUAL "bool")
      string(APPEND methods "  vtkSetMacro(${name}, bool);\n  vtkGetMacro(${name}, bool);\n"
        "  vtkBooleanMacro(${name}, bool);\n")
      string(APPEND members "  bool ${name} = ${default};\n")
      set(printed "onOrOff(this->${name})")
      set(forwarder "vtkTetMarchForwardSwitchMacro(${name})")
    elseif (type STREQUAL "double[2]")
      string(JSON low GET "${default}" 0)
      string(JSON high GET "${default}" 1)
      string(APPEND methods "  vtkSetVector2Macro(${name}, double);\n  vtkGetVector2Macro(${name}, double);\n")
      string(APPEND members "  double ${name}[2] = { ${low}, ${high} };\n")
      set(printed "this->${name}[0] << \", \" << this->${name}[1]")
      set(forwarder "vtkTetMarchForwardVector2Macro(${name}, double)")
    else ()
      if (greatest STREQUAL "")
        set(greatest "${most_of_${type}}")
      endif ()
      string(APPEND methods "  vtkSetClampMacro(${name}, ${type}, ${least}, ${greatest});\n"
        "  vtkGetMacro(${name}, ${type});\n")
      string(APPEND members "  ${type} ${name} = ${default};\n")
    endif ()
    string(APPEND lines "  os << indent << \"${name}: \" << ${printed} << \"\\n\";\n")
    set(owner own)
    if (inherited)
      set(owner inherited)
    endif ()
    string(APPEND "${owner}_forwarders" "  ${forwarder}; \\\n${to_choices}")
  endforeach ()
  # Each group ends where the next one begins.
  string(REGEX REPLACE "^  //@}\n\n" "" methods "${methods}")
  string(APPEND methods "  //@}\n")
  string(REGEX REPLACE "\n$" "" lines "${lines}")
  # Whoever uses a macro writes its last semicolon.
  foreach (list IN ITEMS enums own_forwarders inherited_forwarders)
    string(REGEX REPLACE "; \\\\\n$" "" "${list}" "${${list}}")
  endforeach ()
  configure_file("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/vtkTetMarchSettings.h.in"
    "${header_dir}/vtkTetMarchSettings.h" @ONLY)
  configure_file("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/vtkTetMarchSettingsMacros.h.in"
    "${header_dir}/vtkTetMarchSettingsMacros.h" @ONLY)
  configure_file("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/vtkTetMarchSettings.cxx.in"
    "${source_dir}/vtkTetMarchSettings.cxx" @ONLY)
endfunction ()
