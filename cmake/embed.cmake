# Writes text files as a C++ source of string views. Run as a script by a custom command:
#   cmake -DOUT=file.cpp -DHEADER=report/assets.h "-DPARTS=kName=a.js,b.js|kOther=c.css" -P embed.cmake
# Several files of one name follow each other.
string(REPLACE "|" ";" parts "${PARTS}")
set(text "// Made by cmake/embed.cmake.\n#include \"${HEADER}\"\n\nnamespace sunfleck::engine {\n")
foreach(part IN LISTS parts)
  string(REGEX MATCH "^([^=]+)=(.*)$" _ "${part}")
  set(name "${CMAKE_MATCH_1}")
  string(REPLACE "," ";" files "${CMAKE_MATCH_2}")
  string(APPEND text "\nconst std::string_view ${name} =")
  foreach(file IN LISTS files)
    file(READ "${file}" content)
    string(APPEND text " R\"embedded(${content})embedded\"")
  endforeach()
  string(APPEND text ";\n")
endforeach()
string(APPEND text "\n}  // namespace sunfleck::engine\n")
file(WRITE "${OUT}" "${text}")
