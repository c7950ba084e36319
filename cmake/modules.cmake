# What nearly every file includes, compiled once: see cmake/flags.cmake.
set(SUNFLECK_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <memory>
  <optional> <span> <string> <variant> <vector> <fmt/format.h>)

# One static library a module of src/: its files are globbed, its libraries named here and nowhere
# else. src/layers.txt says who may include whom; tools/check_layers.py checks it.
# Files are compiled several at a time, but ALONE those that have local names in common with others.
function(sunfleck_module name)
  cmake_parse_arguments(MODULE "" "FOLDER" "ALONE;NEEDS" ${ARGN})
  if(NOT MODULE_FOLDER)
    set(MODULE_FOLDER ${name})
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${MODULE_FOLDER}/*.cpp)
  if(sources)
    add_library(module_${name} STATIC ${sources})
    target_link_libraries(module_${name} PUBLIC sunfleck_flags ${MODULE_NEEDS})
    list(TRANSFORM MODULE_ALONE REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/src/${MODULE_FOLDER}/\\1.cpp")
    sunfleck_compile_together(module_${name} ALONE ${MODULE_ALONE})
    # Whoever includes the scene does so in nearly every file; the others share the common headers.
    if(name STREQUAL "core")
      target_precompile_headers(module_core PRIVATE ${SUNFLECK_COMMON_HEADERS})
    elseif(name STREQUAL "scene")
      target_precompile_headers(module_scene PRIVATE ${SUNFLECK_COMMON_HEADERS}
        "${PROJECT_SOURCE_DIR}/src/scene/scene.h")
    elseif(MODULE_NEEDS MATCHES "module_(scene|camera_paths|photon|stages|import_pbrt)")
      target_precompile_headers(module_${name} REUSE_FROM module_scene)
    else()
      target_precompile_headers(module_${name} REUSE_FROM module_core)
    endif()
  else()
    add_library(module_${name} INTERFACE)
    target_link_libraries(module_${name} INTERFACE sunfleck_flags ${MODULE_NEEDS})
  endif()
endfunction()

sunfleck_module(core NEEDS TBB::tbb fmt::fmt ZLIB::ZLIB)
sunfleck_module(math NEEDS module_core Imath::Imath)
sunfleck_module(image NEEDS module_math OpenEXR::OpenEXR PNG::PNG JPEG::JPEG webp)
sunfleck_module(bsdf ALONE facet_losses NEEDS module_math)
sunfleck_module(geometry ALONE curve_surface NEEDS module_math embree)
sunfleck_module(camera NEEDS module_math)
sunfleck_module(random_numbers NEEDS module_math)
sunfleck_module(guide ALONE emission_guide_builder NEEDS module_random_numbers)
sunfleck_module(chains NEEDS module_guide)
sunfleck_module(procedural ALONE brandy cognac cornell cornell_door diamond lamp_room magnifier
    scene_folder two_windows watch watch_parts NEEDS module_math)
sunfleck_module(import_ply FOLDER import/ply NEEDS module_math)
sunfleck_module(import_stl FOLDER import/stl NEEDS module_geometry)
sunfleck_module(import_obj FOLDER import/obj NEEDS module_import_ply)
sunfleck_module(texture NEEDS module_image module_geometry)
sunfleck_module(material NEEDS module_bsdf module_texture)
sunfleck_module(medium NEEDS module_bsdf module_geometry)
sunfleck_module(light NEEDS module_geometry module_image module_medium)
sunfleck_module(aovs NEEDS module_math)
sunfleck_module(visible_points ALONE lookup NEEDS module_bsdf module_geometry module_aovs hwy::hwy)
sunfleck_module(scene NEEDS module_material module_light module_camera module_medium)
sunfleck_module(sky NEEDS module_scene)
sunfleck_module(import_ies FOLDER import/ies NEEDS module_light)
sunfleck_module(import_nvdb FOLDER import/nvdb NEEDS module_medium)
sunfleck_module(import_pbrt FOLDER import/pbrt ALONE materials texture_kinds world_directives
  NEEDS module_sky module_import_ply module_import_ies module_import_nvdb)
sunfleck_module(import_gltf FOLDER import/gltf ALONE draco
  NEEDS module_import_ies module_scene nlohmann_json::nlohmann_json ${SUNFLECK_UNPACKERS})
target_compile_definitions(module_import_gltf PRIVATE $<$<BOOL:${SUNFLECK_DRACO}>:SUNFLECK_DRACO>
  $<$<BOOL:${SUNFLECK_MESHOPT}>:SUNFLECK_MESHOPT>)
sunfleck_module(import_part FOLDER import/part
  NEEDS module_scene module_import_obj module_import_stl)
sunfleck_module(export NEEDS module_scene)
sunfleck_module(camera_paths NEEDS module_scene module_visible_points module_random_numbers)
sunfleck_module(mattes NEEDS module_scene module_random_numbers)
sunfleck_module(photon ALONE light_strata NEEDS module_scene module_visible_points module_chains)
sunfleck_module(estimate NEEDS module_scene module_visible_points)
sunfleck_module(film NEEDS module_image module_visible_points nlohmann_json::nlohmann_json)
sunfleck_module(reference NEEDS module_scene module_aovs module_random_numbers)
sunfleck_module(compare NEEDS module_image nlohmann_json::nlohmann_json)
sunfleck_module(import NEEDS module_import_pbrt module_import_gltf module_import_part module_import_ies module_sky)
sunfleck_module(ranks NEEDS module_film)
sunfleck_module(photon_samplers NEEDS module_photon module_estimate)
sunfleck_module(stages NEEDS module_camera_paths module_photon_samplers module_film)
sunfleck_module(planning NEEDS module_stages)
sunfleck_module(flags NEEDS module_stages module_import)
sunfleck_module(render NEEDS module_planning module_ranks module_reference)
sunfleck_module(stats NEEDS module_render nlohmann_json::nlohmann_json)
sunfleck_module(live ALONE server site site_pictures site_wishes
  NEEDS module_render module_flags nlohmann_json::nlohmann_json)
target_link_libraries(module_live PRIVATE sunfleck_http)
sunfleck_module(display NEEDS module_image)
sunfleck_module(library NEEDS module_stats module_flags module_import)
file(GLOB figures CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/experiment/figures/*.cpp)
sunfleck_module(experiment NEEDS module_import module_procedural module_report module_film nlohmann_json::nlohmann_json)
target_sources(module_experiment PRIVATE ${figures})
sunfleck_module(report NEEDS module_compare)

# The laboratory (see src/layers.txt): what the programs link beside the renderer.
add_library(sunfleck_lab INTERFACE)
target_link_libraries(sunfleck_lab INTERFACE module_experiment module_procedural module_report)

# sunfleck_embed(MODULE PARTS [DEPENDS files...]): pages' files inside the program, as PARTS of
# cmake/embed.cmake, declared by the module's assets.h.
function(sunfleck_embed module parts)
  cmake_parse_arguments(E "" "" "DEPENDS" ${ARGN})
  set(assets ${PROJECT_BINARY_DIR}/${module}_assets.cpp)
  add_custom_command(OUTPUT ${assets}
    COMMAND ${CMAKE_COMMAND} -DOUT=${assets} -DHEADER=${module}/assets.h "-DPARTS=${parts}"
      -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${E_DEPENDS} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    VERBATIM)
  target_sources(module_${module} PRIVATE ${assets})
  set_source_files_properties(${assets} PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)
endfunction()

# What pages have in common, the page of comparisons with the chart library, and that of a render.
set(common ${PROJECT_SOURCE_DIR}/src/report/common)
set(page ${PROJECT_SOURCE_DIR}/src/report/page)
set(live ${PROJECT_SOURCE_DIR}/src/live/page)
file(GLOB common_scripts CONFIGURE_DEPENDS ${common}/*.js)
file(GLOB page_scripts CONFIGURE_DEPENDS ${page}/*.js)
file(GLOB live_scripts CONFIGURE_DEPENDS ${live}/*.js)
string(REPLACE ";" "," page_joined "${common_scripts};${page_scripts}")
string(REPLACE ";" "," live_joined "${common_scripts};${live_scripts}")
sunfleck_embed(report
  "kBaseStyle=${common}/base.css|kPage=${page}/page.html|kPageStyle=${common}/base.css,${page}/page.css|kPageScript=${page_joined}|kChartLibrary=${SUNFLECK_CHART_JS}"
  DEPENDS ${page}/page.html ${page}/page.css ${common}/base.css ${common_scripts} ${page_scripts}
    ${SUNFLECK_CHART_JS})
sunfleck_embed(live
  "kLivePage=${live}/page.html|kLiveStyle=${common}/base.css,${live}/page.css|kLiveScript=${live_joined}"
  DEPENDS ${live}/page.html ${live}/page.css ${common}/base.css ${common_scripts} ${live_scripts})
