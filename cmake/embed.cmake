# SPDX-License-Identifier: GPL-3.0-or-later
# Run by pellucid_embed: writes OUTPUT.h and OUTPUT.cpp with the bytes of FILES (absolute paths; named from ROOT on).
# The assembler's .incbin copies megabytes at once where a C array would take minutes to compile.
get_filename_component(header ${OUTPUT} NAME)
set(h "#pragma once\n\n#include <span>\n#include <string_view>\n\nnamespace ${NAMESPACE} {\n\n"
  "struct File {\n  std::string_view path;\n  std::string_view (*text)();\n};\nstd::span<const File> files();\n\n")
set(cpp "#include \"${header}.h\"\n\n")
set(functions "")
set(table "")
foreach(file ${FILES})
  get_filename_component(name ${file} NAME)
  string(MAKE_C_IDENTIFIER ${name} id)
  set(symbol ${NAMESPACE}_${id})
  string(APPEND h "std::string_view ${id}();\n")
  string(APPEND cpp
    "asm(\".section .rodata\\n\" \".global ${symbol}\\n\" \".global ${symbol}_end\\n\"\n"
    "    \"${symbol}:\\n\" \".incbin \\\"${file}\\\"\\n\" \"${symbol}_end:\\n\" \".byte 0\\n\" \".previous\\n\");\n"
    "extern \"C\" const char ${symbol}[];\nextern \"C\" const char ${symbol}_end[];\n")
  file(RELATIVE_PATH path ${ROOT} ${file})
  string(APPEND table "    {\"${path}\", ${NAMESPACE}::${id}},\n")
  string(APPEND functions
    "std::string_view ${NAMESPACE}::${id}() { return {${symbol}, std::size_t(${symbol}_end - ${symbol})}; }\n")
endforeach()
string(APPEND h "\n}  // namespace ${NAMESPACE}\n")
file(WRITE ${OUTPUT}.h "${h}")
string(APPEND functions "\nnamespace {\nconstexpr ${NAMESPACE}::File table[] = {\n${table}};\n}  // namespace\n\n"
  "std::span<const ${NAMESPACE}::File> ${NAMESPACE}::files() { return table; }\n")
file(WRITE ${OUTPUT}.cpp "${cpp}\n${functions}")
