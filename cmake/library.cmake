# libsunfleck, shared and static: the interface of include/sunfleck and the modules that it needs; and
# what of it is installed, for find_package(sunfleck) and pkg-config.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

configure_file(include/sunfleck/version.h.in include/sunfleck/version.h @ONLY)

# The modules that a module needs, itself among them, and the outside libraries that these need.
function(sunfleck_closure module modules_out libraries_out)
  set(waiting ${module})
  while(waiting)
    list(POP_FRONT waiting next)
    if(next IN_LIST modules OR next IN_LIST libraries OR next STREQUAL "sunfleck_flags")
      continue()
    elseif(next MATCHES "^module_")
      list(APPEND modules ${next})
      get_target_property(needs ${next} INTERFACE_LINK_LIBRARIES)
      list(APPEND waiting ${needs})
    else()
      list(APPEND libraries ${next})
    endif()
  endwhile()
  set(${modules_out} ${modules} PARENT_SCOPE)
  set(${libraries_out} ${libraries} PARENT_SCOPE)
endfunction()

sunfleck_closure(module_library modules libraries)
foreach(module ${modules})
  get_target_property(type ${module} TYPE)
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    list(APPEND objects $<TARGET_OBJECTS:${module}>)
  endif()
endforeach()
# Headers alone: no library's user needs them.
list(REMOVE_ITEM libraries nlohmann_json::nlohmann_json)

# Before 1.0 each minor version may change the interface.
set(so_version ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(exports ${PROJECT_SOURCE_DIR}/cmake/exports.map)
add_library(sunfleck_shared SHARED ${objects})
add_library(sunfleck_static STATIC ${objects})
set_target_properties(sunfleck_shared PROPERTIES EXPORT_NAME sunfleck VERSION ${PROJECT_VERSION}
  SOVERSION ${so_version} LINK_DEPENDS ${exports})
set_target_properties(sunfleck_static PROPERTIES EXPORT_NAME static)
target_link_options(sunfleck_shared PRIVATE -Wl,--version-script=${exports} -Wl,--no-undefined)
foreach(library sunfleck_shared sunfleck_static)
  set_target_properties(${library} PROPERTIES OUTPUT_NAME sunfleck LINKER_LANGUAGE CXX)
  target_link_libraries(${library} PRIVATE ${libraries})
  target_compile_features(${library} INTERFACE cxx_std_20)
  target_include_directories(${library} INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endforeach()

install(TARGETS sunfleck_shared EXPORT sunfleck_shared)
install(TARGETS sunfleck_static EXPORT sunfleck_static)
install(DIRECTORY include/sunfleck TYPE INCLUDE FILES_MATCHING PATTERN "*.h")
install(FILES ${PROJECT_BINARY_DIR}/include/sunfleck/version.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sunfleck)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/sunfleck)
install(EXPORT sunfleck_shared FILE sunfleckTargets.cmake NAMESPACE sunfleck:: DESTINATION ${package})
install(EXPORT sunfleck_static FILE sunfleckStaticTargets.cmake NAMESPACE sunfleck::
  DESTINATION ${package})
configure_package_config_file(cmake/sunfleckConfig.cmake.in sunfleckConfig.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(sunfleckConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/sunfleckConfig.cmake
  ${PROJECT_BINARY_DIR}/sunfleckConfigVersion.cmake DESTINATION ${package})
# The prefix as seen from the file: a tree may be installed anywhere.
file(RELATIVE_PATH SUNFLECK_TO_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
foreach(package sunfleck sunfleck-static)
  configure_file(cmake/${package}.pc.in ${package}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${package}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()

# The program, its man pages and its completion.
install(TARGETS sunfleck)
install(DIRECTORY ${PROJECT_BINARY_DIR}/share/ DESTINATION ${CMAKE_INSTALL_DATADIR})
install(FILES LICENSE NOTICE TYPE DOC)
