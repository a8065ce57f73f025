# exabricks_warnings(): warnings for what the calling folder builds. They are not passed on to users of the library.
function (exabricks_warnings)
  add_compile_options("$<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang>:-Wall;-Wextra>")
endfunction ()
