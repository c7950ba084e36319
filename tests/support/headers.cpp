// Nothing of its own: CMake compiles the headers that tests share beside a file.
