// OpenImageIO 2.4 leaves its PNG reader by longjmp when a file is cut off, past the destructor of
// the message that it was about to report.
#if defined(__SANITIZE_ADDRESS__)
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:ImageInput::geterror"; }
#endif
