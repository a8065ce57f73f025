# From Debian 13 on ParaView's Python modules are named `vtkCommonCore.cpython-<version>.so`, while ParaView's CMake package
# insists on files `vtkCommonCore.so`, and stops. Nothing here links them, and a set of exported targets that is declared
# already is not checked.

# exabricks_declare_misnamed_python_modules(): of the ParaView in ParaView_DIR, or else of Debian's
function (exabricks_declare_misnamed_python_modules)
  if (ParaView_DIR)
    set(folders "${ParaView_DIR}")
  elseif (NOT CMAKE_PREFIX_PATH)
    file(GLOB folders "/usr/lib/*/cmake/paraview-*")
  endif ()
  foreach (folder IN LISTS folders)
    foreach (set IN ITEMS ParaViewPython ParaViewPythonIncubator vtk/VTKPython)
      set(file "${folder}/${set}-targets.cmake")
      file(GLOB locations "${folder}/${set}-targets-*.cmake")
      if (NOT locations)
        continue ()
      endif ()
      list(GET locations 0 locations)
      file(STRINGS "${locations}" location LIMIT_COUNT 1
        REGEX "IMPORTED_LOCATION.*dist-packages/")
      string(REGEX REPLACE "^.*(/dist-packages/.*)\"$" "/usr/lib/python3\\1" location "${location}")
      file(STRINGS "${file}" targets LIMIT_COUNT 1 REGEX "IN ITEMS")
      if (NOT location OR EXISTS "${location}" OR NOT targets MATCHES "IN ITEMS (.*)\\)")
        continue ()
      endif ()
      string(REPLACE " " ";" targets "${CMAKE_MATCH_1}")
      foreach (target IN LISTS targets)
        add_library("${target}" INTERFACE IMPORTED GLOBAL)
      endforeach ()
    endforeach ()
  endforeach ()
endfunction ()
