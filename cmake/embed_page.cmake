# cmake -D PAGE=FILE -D SOURCE=FILE -P embed_page.cmake
# Writes the C++ source of viewer_page(): the bytes of PAGE, none where PAGE is empty.
set(BYTES "0x00,")
set(SIZE 0)
if(PAGE)
  file(READ ${PAGE} HEX HEX)
  file(SIZE ${PAGE} SIZE)
  string(REGEX REPLACE "(..)" "0x\\1," BYTES "${HEX}")
endif()
file(WRITE ${SOURCE} "#include \"cli/viewer_page.h\"

static const unsigned char kBytes[] = {${BYTES}};

std::string_view viewer_page() { return {reinterpret_cast<const char*>(kBytes), ${SIZE}}; }
")
