# Prints each sentence of more than 25 words in pages and in documentation comments:
# awk -f sentences.awk FILE...
# A sentence ends with a full stop, a question mark or an exclamation mark before a space, or with
# its paragraph, its point of a list or its cell of a table. Code blocks, addresses and generated
# hashes are exempt.
# Ends a paragraph, a row's cell or a point of a list: counts the words of each of its sentences. A
# piece of code is a word, and so is a number with thin groups.
function check(text, i, n, sentences, words, k, count) {
    gsub(/``[^`]*(`[^`]+)*``|`[^`]*`/, "code", text)
    gsub(/\]\([^)]*\)|\]\[[^]]*\]|[][]/, "", text)
    while (match(text, /[0-9] [0-9][0-9][0-9]/)) text = substr(text, 1, RSTART) substr(text, RSTART + 2)
    gsub(/[.!?]["*_)]* /, "&\n", text)
    n = split(text, sentences, "\n")
    for (i = 1; i <= n; i++) {
        count = 0
        k = split(sentences[i], words, " ")
        for (; k; k--) count += words[k] ~ /[0-9A-Za-z]/
        if (count > 25) { printf "%s:%d: a sentence of %d words: %s\n", name, first, count, sentences[i]; bad++ }
    }
}
function close_paragraph() { if (paragraph != "") check(paragraph); paragraph = "" }
FNR == 1 { close_paragraph(); fence = 0; is_rust = FILENAME ~ /\.rs$/; name = FILENAME }
{
    line = $0
    if (is_rust && !sub(/^ *\/\/[\/!] ?/, "", line)) { close_paragraph(); fence = 0; next }
    if (line ~ /^ *```/) { close_paragraph(); fence = !fence; next }
    if (fence) next
    if (line ~ /^ *($|<|\[[^]]*\]: )/ || line ~ /^- `[^`]*`: .* [0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]/) { close_paragraph(); next }
    if (line ~ /^ *\|/) {
        close_paragraph()
        first = FNR
        cells = split(line, cell, "|")
        for (c = 1; c <= cells; c++) check(cell[c])
        next
    }
    if (line ~ /^ *(#+|[-*+]|[0-9]+\.) /) close_paragraph()
    if (paragraph == "") { first = FNR; sub(/^ *(#+|[-*+]|[0-9]+\.) /, "", line) }
    sub(/^ */, "", line)
    paragraph = paragraph (paragraph == "" ? "" : " ") line
}
END { close_paragraph(); exit bad > 0 }
