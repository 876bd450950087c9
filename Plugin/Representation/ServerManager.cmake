# What ParaView is told of the representations. Its XML has no way to include a file, so that what both have in common
# is put in here: settings, other properties, and where all of them are in the panel. Names behind the kind of data are
# properties that the base proxy has, too. ParaView 6.1 drops a property that says to override one of the base proxy,
# if there is none.
include("${CMAKE_CURRENT_LIST_DIR}/SettingsXml.cmake")
set(tetmarch_server_manager_xml
  "${CMAKE_CURRENT_SOURCE_DIR}/Representation/DualGrid.xml" "${CMAKE_CURRENT_SOURCE_DIR}/Representation/LastFrame.xml"
  "${CMAKE_CURRENT_SOURCE_DIR}/Representation/Tessellator.xml"
  "${CMAKE_CURRENT_SOURCE_DIR}/Representation/WebPage.xml")

function (tetmarch_add_server_manager_xml name kind)
  tetmarch_settings_xml("${kind}")
  foreach (part IN ITEMS Properties BlendGroup OtherGroups)
    set(file "${CMAKE_CURRENT_SOURCE_DIR}/Representation/${part}.xml.in")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    file(READ "${file}" text)
    string(CONFIGURE "${text}" text @ONLY)
    string(REGEX REPLACE "([a-z])([A-Z])" "\\1_\\2" variable "${part}")
    string(TOUPPER "TETMARCH_${variable}" variable)
    set("${variable}" "${text}")
  endforeach ()
  foreach (properties IN ITEMS TETMARCH_SETTINGS TETMARCH_PROPERTIES)
    set(text "${${properties}}")
    foreach (property IN LISTS ARGN)
      string(REGEX REPLACE "(name=\"${property}\"[^>]*)override=\"1\"" "\\1replaces=\"1\"" text "${text}")
    endforeach ()
    string(REGEX REPLACE "\n *override=\"1\"" "" text "${text}")
    string(REPLACE "replaces=\"1\"" "override=\"1\"" "${properties}" "${text}")
  endforeach ()
  set(TETMARCH_EXTENSIONS "")
  set(file "${CMAKE_CURRENT_SOURCE_DIR}/Representation/GridExtension.xml.in")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  file(READ "${file}" extension)
  set(extended_representations UnstructuredGrid StructuredGrid AMR HyperTreeGrid Geometry)
  if (TARGET VTK::FiltersCellGrid AND VTK_VERSION VERSION_GREATER_EQUAL 9.5)
    list(APPEND extended_representations CellGrid)
  endif ()
  foreach (extended IN LISTS extended_representations)
    string(CONFIGURE "${extension}" text @ONLY)
    if (extended STREQUAL "CellGrid")
      string(REPLACE "subproxy=\"SurfaceRepresentation\"" "subproxy=\"CellGridSurfaceRepresentation\"" text "${text}")
    endif ()
    if (extended MATCHES "^(HyperTreeGrid|CellGrid|Geometry)$") # have no stock "Volume", whose functions of the array would be shared
      string(REGEX REPLACE "<ShareProperties subproxy=\"VolumeRepresentation\">.*</ShareProperties>" "" text "${text}")
      string(REGEX REPLACE "exposed_name=\"TetMarch(ScalarOpacity[A-Za-z]+)\"" "exposed_name=\"\\1\"" text "${text}")
    endif ()
    string(APPEND TETMARCH_EXTENSIONS "${text}")
  endforeach ()
  set(xml "${CMAKE_CURRENT_BINARY_DIR}/${name}.xml")
  configure_file("${CMAKE_CURRENT_SOURCE_DIR}/Representation/${name}.xml.in" "${xml}" @ONLY)
  set(tetmarch_server_manager_xml ${tetmarch_server_manager_xml} "${xml}" PARENT_SCOPE)
endfunction ()

tetmarch_add_server_manager_xml(TetMarch grids ScalarOpacityUnitDistance)
tetmarch_add_server_manager_xml(TetMarchImage images Ambient BlendMode CroppingOrigin CroppingScale Diffuse DummyInput
  GlobalIlluminationReach IsosurfaceValues ScalarOpacityUnitDistance Shade Specular SpecularPower UseCropping
  VolumetricScatteringBlending)
