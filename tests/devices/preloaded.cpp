// umockdev has to be loaded first, where AddressSanitizer wants to be; that it is not does no harm to what
// these tests look for.
extern "C" const char* __asan_default_options() { return "verify_asan_link_order=0"; }
