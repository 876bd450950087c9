# What ParaView is told of the representations. Its XML has no way to include a file, so that what both have in common
# is put in here: properties, and where they are in the panel. BASE_PROPERTY... are those of them that the base proxy has,
# too. ParaView 6.1 drops a property that says to override one of the base proxy, if there is none.
set(tetmarch_server_manager_xml "${CMAKE_CURRENT_SOURCE_DIR}/Representation/LastFrame.xml")
function (tetmarch_add_server_manager_xml name TETMARCH_OPACITY_LAW)
  foreach (part IN ITEMS Settings BlendGroup QualityGroup OtherGroups)
    set(file "${CMAKE_CURRENT_SOURCE_DIR}/Representation/${part}.xml.in")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    file(READ "${file}" text)
    string(CONFIGURE "${text}" text @ONLY)
    string(REGEX REPLACE "\n$" "" text "${text}")
    foreach (property IN LISTS ARGN)
      string(REGEX REPLACE "(name=\"${property}\"[^>]*)override=\"1\"" "\\1replaces=\"1\"" text "${text}")
    endforeach ()
    string(REGEX REPLACE "\n *override=\"1\"" "" text "${text}")
    string(REPLACE "replaces=\"1\"" "override=\"1\"" text "${text}")
    string(REGEX REPLACE "([a-z])([A-Z])" "\\1_\\2" variable "${part}")
    string(TOUPPER "TETMARCH_${variable}" variable)
    set("${variable}" "${text}")
  endforeach ()
  set(xml "${CMAKE_CURRENT_BINARY_DIR}/${name}.xml")
  configure_file("Representation/${name}.xml.in" "${xml}" @ONLY)
  set(tetmarch_server_manager_xml ${tetmarch_server_manager_xml} "${xml}" PARENT_SCOPE)
endfunction ()

# With the value of the opacity law by default: that of ParaView's own volume rendering of such data.
tetmarch_add_server_manager_xml(TetMarch 0 ScalarOpacityUnitDistance)
tetmarch_add_server_manager_xml(TetMarchImage 1 Ambient BlendMode CroppingOrigin CroppingScale Diffuse DummyInput
  GlobalIlluminationReach IsosurfaceValues ScalarOpacityUnitDistance Shade Specular SpecularPower UseCropping
  VolumetricScatteringBlending)
