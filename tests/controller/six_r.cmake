# Listed in CMakeLists.txt.
