# Compile options shared by the library, the program and the tests; never exported to users.
add_library(retiarius_options INTERFACE)
target_compile_options(retiarius_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wcast-qual -Woverloaded-virtual
  # Results must not depend on the compiler's choice to fuse or reorder operations.
  -ffp-contract=off)
if(RETIARIUS_WARNINGS_AS_ERRORS)
  target_compile_options(retiarius_options INTERFACE -Werror)
endif()
if(RETIARIUS_SANITIZE)
  target_compile_options(retiarius_options INTERFACE
    -fsanitize=${RETIARIUS_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(retiarius_options INTERFACE -fsanitize=${RETIARIUS_SANITIZE})
endif()
if(RETIARIUS_FUZZ)
  # Tells libFuzzer which branches an input takes.
  target_compile_options(retiarius_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
