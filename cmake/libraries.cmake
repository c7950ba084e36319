# The outside libraries, all from Debian 12.
find_file(SUNFLECK_CHART_JS chart.min.js HINTS /usr /usr/local
  PATH_SUFFIXES share/javascript/chart.js REQUIRED)
find_package(embree 3 REQUIRED)
find_package(TBB REQUIRED)
find_package(hwy REQUIRED)
find_package(Imath REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
