#!/bin/sed -f
# For Doxygen, which does not know a page's headings as GitHub does: links go to pages, not to places in them.
s|\[\([^]]*\)\](#[^)]*)|\1|g
s|\.md#[^)]*)|.md)|g
