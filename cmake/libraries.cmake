# The outside libraries, all from Debian 12.
find_file(SUNFLECK_CHART_JS chart.min.js HINTS /usr /usr/local
  PATH_SUFFIXES share/javascript/chart.js REQUIRED)
find_package(embree 3 REQUIRED)
find_package(TBB REQUIRED)
find_package(hwy REQUIRED)
# Debian's file of Imath lists a library of Python that no renderer needs, and tells that it is missing.
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
find_package(Imath REQUIRED)
find_package(OpenEXR REQUIRED)
unset(CMAKE_MESSAGE_LOG_LEVEL)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
