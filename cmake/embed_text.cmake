# cmake -DINPUT=FILE -DOUTPUT=FILE.cc -P embed_text.cmake
#
# Writes the text of INPUT, ASCII, as the C++ source that defines tumble::golden::report_script_pieces() and
# report_script_sha256(). The text is in pieces, because compilers need not take a string literal longer than 65536
# characters.
file(READ ${INPUT} text)
string(LENGTH "${text}" length)
set(size 32000)
set(code "#include \"golden/report/page/script.h\"\n\nnamespace tumble::golden {\n\n")
string(APPEND code "std::vector<std::string_view> report_script_pieces() {\n  return {\n")
set(at 0)
while(at LESS length)
  string(SUBSTRING "${text}" ${at} ${size} piece)
  string(APPEND code "R\"piece(${piece})piece\",\n")
  math(EXPR at "${at} + ${size}")
endwhile()
file(SHA256 ${INPUT} hash)
string(APPEND code "  };\n}\n\nstd::string_view report_script_sha256() { return \"${hash}\"; }\n\n}  // namespace tumble::golden\n")
file(WRITE ${OUTPUT} "${code}")
