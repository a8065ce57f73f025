# exabricks_compile_shader(<headers> <source> {<variant> <definitions>}...)
#
# Compiles <source> (in Shaders/, or with its full path) twice for each variant, with <definitions> set, into headers
# <variant>Spirv.h that holds `const uint32_t <variant>Spirv[]`, and <variant>Int64Spirv.h for devices with integers of
# 64 bits (Shaders/Buffers.glsl); and puts the list of headers into <headers>. They lie in EXABRICKS_SPIRV_DIR. What the
# shader includes (Shaders/Layout.h, Shaders/*.glsl, what lies beside it) is followed through the compiler's depfile.

# Paths in depfiles are those that the compiler was given.
if (POLICY CMP0116)
  cmake_policy(SET CMP0116 NEW)
endif ()

find_program(EXABRICKS_GLSLANG NAMES glslangValidator glslang REQUIRED
  HINTS "$ENV{VULKAN_SDK}/bin"
  DOC "GLSL compiler (Debian: glslang-tools)")
mark_as_advanced(EXABRICKS_GLSLANG)

# Where glslang was built with SPIRV-Tools: what is inlined beforehand takes drivers a fifth less time to compile.
execute_process(COMMAND "${EXABRICKS_GLSLANG}" -Os --version RESULT_VARIABLE optimize_failed OUTPUT_QUIET ERROR_QUIET)
set(EXABRICKS_GLSLANG_OPTIMIZE)
if (NOT optimize_failed)
  set(EXABRICKS_GLSLANG_OPTIMIZE -Os)
endif ()

set(EXABRICKS_SHADER_DIR "${CMAKE_CURRENT_LIST_DIR}")
set(EXABRICKS_SPIRV_DIR "${CMAKE_CURRENT_BINARY_DIR}/Spirv")
file(MAKE_DIRECTORY "${EXABRICKS_SPIRV_DIR}")

function (exabricks_compile_shader headers source)
  set(outputs)
  if (NOT IS_ABSOLUTE "${source}")
    set(source "${EXABRICKS_SHADER_DIR}/${source}")
  endif ()
  get_filename_component(name "${source}" NAME)
  while (ARGN)
    list(POP_FRONT ARGN variant words)
    separate_arguments(words)
    list(TRANSFORM words PREPEND "-D")
    foreach (suffix IN ITEMS "" Int64)
      set(definitions ${words})
      if (suffix)
        list(APPEND definitions -DHAS_INT64)
      endif ()
      set(output "${EXABRICKS_SPIRV_DIR}/${variant}${suffix}Spirv.h")
      add_custom_command(
        OUTPUT "${output}"
        COMMAND "${EXABRICKS_GLSLANG}" --quiet -V ${EXABRICKS_GLSLANG_OPTIMIZE} --target-env vulkan1.2
                ${definitions} "-I${EXABRICKS_SHADER_DIR}"
                --vn "${variant}${suffix}Spirv" --depfile "${output}.d" -o "${output}"
                "${source}"
        DEPENDS "${source}"
        DEPFILE "${output}.d"
        COMMENT "Compiling ${name} with ${words} ${suffix}"
        VERBATIM)
      list(APPEND outputs "${output}")
    endforeach ()
  endwhile ()
  set("${headers}" ${outputs} PARENT_SCOPE)
endfunction ()
