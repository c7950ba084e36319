# What nearly every file includes, compiled once: see cmake/flags.cmake.
set(SUNFLECK_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <memory>
  <optional> <span> <string> <variant> <vector> <fmt/format.h>)

# One static library a room of src/: its files are globbed, its libraries named here and nowhere
# else. src/layers.txt says who may include whom; tools/check_layers.py checks it.
# Files are compiled several at a time, but ALONE those that have local names in common with others;
# ONE_BY_ONE: all of them, where these are many or were not looked for.
function(sunfleck_room name)
  cmake_parse_arguments(ROOM "ONE_BY_ONE" "FOLDER" "ALONE;NEEDS" ${ARGN})
  if(NOT ROOM_FOLDER)
    set(ROOM_FOLDER ${name})
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${ROOM_FOLDER}/*.cpp)
  if(sources)
    add_library(room_${name} STATIC ${sources})
    target_link_libraries(room_${name} PUBLIC sunfleck_flags ${ROOM_NEEDS})
    if(NOT ROOM_ONE_BY_ONE)
      list(TRANSFORM ROOM_ALONE REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/src/${ROOM_FOLDER}/\\1.cpp")
      sunfleck_compile_together(room_${name} ALONE ${ROOM_ALONE})
    endif()
    # Whoever includes the scene does so in nearly every file; the others share the common headers.
    if(name STREQUAL "core")
      target_precompile_headers(room_core PRIVATE ${SUNFLECK_COMMON_HEADERS})
    elseif(name STREQUAL "scene")
      target_precompile_headers(room_scene PRIVATE ${SUNFLECK_COMMON_HEADERS}
        "${PROJECT_SOURCE_DIR}/src/scene/scene.h")
    elseif(ROOM_NEEDS MATCHES "room_(scene|eye|import_pbrt)")
      target_precompile_headers(room_${name} REUSE_FROM room_scene)
    else()
      target_precompile_headers(room_${name} REUSE_FROM room_core)
    endif()
  else()
    add_library(room_${name} INTERFACE)
    target_link_libraries(room_${name} INTERFACE sunfleck_flags ${ROOM_NEEDS})
  endif()
endfunction()

sunfleck_room(core NEEDS TBB::tbb fmt::fmt ZLIB::ZLIB)
sunfleck_room(math ONE_BY_ONE NEEDS room_core Imath::Imath)
sunfleck_room(image NEEDS room_math OpenEXR::OpenEXR PNG::PNG JPEG::JPEG)
sunfleck_room(bsdf ONE_BY_ONE NEEDS room_math)
sunfleck_room(geometry ONE_BY_ONE NEEDS room_math embree)
sunfleck_room(camera NEEDS room_math)
sunfleck_room(sampler ONE_BY_ONE NEEDS room_math)
sunfleck_room(procedural ONE_BY_ONE NEEDS room_math)
sunfleck_room(import_ply FOLDER import/ply NEEDS room_math)
sunfleck_room(texture NEEDS room_image room_geometry)
sunfleck_room(material NEEDS room_bsdf room_texture)
sunfleck_room(light NEEDS room_geometry room_image)
sunfleck_room(measurement ONE_BY_ONE NEEDS room_bsdf room_geometry room_sampler hwy::hwy)
sunfleck_room(scene NEEDS room_material room_light room_camera room_measurement)
sunfleck_room(import_pbrt FOLDER import/pbrt ALONE materials texture_kinds world_directives
  NEEDS room_scene room_import_ply)
sunfleck_room(eye NEEDS room_scene)
sunfleck_room(photon ONE_BY_ONE NEEDS room_scene)
sunfleck_room(estimate NEEDS room_scene)
sunfleck_room(film NEEDS room_scene nlohmann_json::nlohmann_json)
sunfleck_room(reference NEEDS room_scene)
sunfleck_room(compare NEEDS room_image nlohmann_json::nlohmann_json)
sunfleck_room(import NEEDS room_import_pbrt)
sunfleck_room(render NEEDS room_eye room_photon room_estimate room_film room_reference)
file(GLOB figures CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/experiment/figures/*.cpp)
sunfleck_room(experiment NEEDS room_import room_procedural room_report nlohmann_json::nlohmann_json)
target_sources(room_experiment PRIVATE ${figures})
sunfleck_room(report NEEDS room_compare)

# The page's own files and the chart library, inside the program.
set(page ${PROJECT_SOURCE_DIR}/src/report/page)
file(GLOB scripts CONFIGURE_DEPENDS ${page}/*.js)
string(REPLACE ";" "," scripts_joined "${scripts}")
set(assets ${PROJECT_BINARY_DIR}/report_assets.cpp)
add_custom_command(OUTPUT ${assets}
  COMMAND ${CMAKE_COMMAND} -DOUT=${assets} -DHEADER=report/assets.h
    "-DPARTS=kPage=${page}/page.html|kPageStyle=${page}/page.css|kPageScript=${scripts_joined}|kChartLibrary=${SUNFLECK_CHART_JS}"
    -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
  DEPENDS ${page}/page.html ${page}/page.css ${scripts} ${SUNFLECK_CHART_JS}
    ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
  VERBATIM)
target_sources(room_report PRIVATE ${assets})
set_source_files_properties(${assets} PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)
