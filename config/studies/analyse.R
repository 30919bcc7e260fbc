# analyse.R FOLDER: the report of a study, from the folder that `carom study export` has written, to report.html and results.csv in it.
# Base R and lme4 alone. `source` gives the functions without running them.

kLevels <- c("pre", "post", "delayed")
kPhaseWords <- c(pre = "before", post = "after", delayed = "delayed")
kFewest <- 12 # people in an arm, below which there are no p-values
kBootstraps <- 5000
kSure <- 3 # confidence from which an answer is a sure one

# ---- reading

readTable <- function(folder, name, required = TRUE) {
  file <- file.path(folder, name)
  if (!file.exists(file)) {
    if (required) stop(sprintf("%s is missing in this folder, expected one that carom study export has written", name), call. = FALSE)
    return(NULL)
  }
  read.csv(file, colClasses = "character", encoding = "UTF-8", na.strings = character(0), check.names = FALSE)
}

needColumns <- function(table, name, columns) {
  missing <- setdiff(columns, names(table))
  if (length(missing)) stop(sprintf("%s has no column %s, expected those of carom study export", name, missing[1]), call. = FALSE)
}

# Returns the rows of tests, of people who are not excluded. An item without an answer counts as one that is not right.
readStudy <- function(folder) {
  responses <- readTable(folder, "responses.csv")
  people <- readTable(folder, "participants.csv")
  needColumns(responses, "responses.csv", c("participant", "arm", "phase", "form", "item", "concept", "answer", "correct", "misconception", "confidence"))
  needColumns(people, "participants.csv", c("participant", "arm", "excluded"))
  facts <- readTable(folder, "study.csv", FALSE)
  facts <- if (is.null(facts)) character(0) else setNames(facts$value, facts$key)
  kept <- people$participant[people$excluded == ""]
  tests <- responses[responses$phase %in% kLevels & responses$participant %in% kept, ]
  begun <- tapply(tests$answer != "", paste(tests$participant, tests$phase), any) # a test without any answer was not taken
  tests <- tests[begun[paste(tests$participant, tests$phase)], ]
  tests$right <- ifelse(tests$correct == "1", 1, 0)
  tests$sure <- suppressWarnings(as.integer(tests$confidence))
  tests$itemForm <- paste0(tests$item, "-", tests$form)
  tests$phase <- factor(tests$phase, kLevels[kLevels %in% tests$phase])
  tests$arm <- factor(tests$arm, unique(people$arm[people$participant %in% kept]))
  ratings <- responses[responses$phase == "rating" & responses$participant %in% kept, ]
  behaviour <- readTable(folder, "behaviour.csv", FALSE)
  list(tests = tests, people = people, ratings = ratings, facts = facts, unexplained = unexplainedBy(behaviour[behaviour$participant %in% kept, ]))
}

# Returns the people who had a lesson that did not explain itself, in no attempt at it.
unexplainedBy <- function(behaviour) {
  if (is.null(behaviour) || !nrow(behaviour) || is.null(behaviour$explained)) return(character(0))
  explained <- tapply(behaviour$explained == "1", list(behaviour$participant, behaviour$lesson), any)
  rownames(explained)[apply(!explained, 1, any, na.rm = TRUE)]
}

fact <- function(study, name, otherwise = "") {
  value <- study$facts[name]
  if (is.na(value) || value == "") otherwise else unname(value)
}

# Returns a row for each person: the per cent of right answers in each test, NA where there was none.
scoresOf <- function(tests) {
  people <- unique(tests[c("participant", "arm")])
  scores <- people[order(match(people$participant, unique(tests$participant))), ]
  for (phase in kLevels) {
    of <- tests[tests$phase == phase, ]
    mean100 <- tapply(of$right, of$participant, mean) * 100
    scores[[phase]] <- as.numeric(mean100[scores$participant])
  }
  scores
}

# ---- effects

# The correction for small samples (L. V. Hedges 1981). With one degree of freedom it is 0: there is no g.
hedgesJ <- function(df) if (df < 2) NA else 1 - 3 / (4 * df - 1)
ratio <- function(a, b) ifelse(b > 0, a / b, NA)

# The statistics of one arm, from matrices of the scores before and after: a column for each (resampled) set of people.
armStatistics <- function(pre, post) {
  change <- post - pre
  n <- nrow(pre)
  meanPre <- colMeans(pre)
  meanPost <- colMeans(post)
  gains <- ifelse(pre < 100, change / (100 - pre), NA)
  sd <- sqrt(colSums(sweep(change, 2, colMeans(change))^2) / (n - 1))
  list(pre = meanPre, post = meanPost, change = meanPost - meanPre,
       gain = ratio(meanPost - meanPre, 100 - meanPre), gains = colMeans(gains, na.rm = TRUE),
       g = ratio(hedgesJ(n - 1) * (meanPost - meanPre), sd), sd = sd, n = n)
}

# Returns the same of `times` sets of people, drawn with replacement from the arm.
resampled <- function(scores, times) {
  n <- nrow(scores)
  drawn <- matrix(sample.int(n, n * times, TRUE), n)
  armStatistics(matrix(scores$pre[drawn], n), matrix(scores$post[drawn], n))
}

interval <- function(values) {
  values <- values[is.finite(values)]
  if (length(values) < 2) c(NA, NA) else unname(quantile(values, c(0.025, 0.975)))
}

# The difference between two arms in the mean change, and Hedges' g of it.
betweenArms <- function(a, b) {
  pooled <- sqrt(((a$n - 1) * a$sd^2 + (b$n - 1) * b$sd^2) / (a$n + b$n - 2))
  list(change = b$change - a$change, gain = b$gain - a$gain, g = ratio(hedgesJ(a$n + b$n - 2) * (b$change - a$change), pooled))
}

# Returns for each arm, and for each arm against the first, the estimates with intervals by a bootstrap over people.
effectsOf <- function(scores, seed, times = kBootstraps) {
  set.seed(seed)
  whole <- scores[!is.na(scores$pre) & !is.na(scores$post), ]
  arms <- split(whole, whole$arm, drop = TRUE)
  arms <- arms[vapply(arms, nrow, 1L) >= 2]
  found <- lapply(arms, function(of) armStatistics(matrix(of$pre), matrix(of$post)))
  drawn <- lapply(arms, resampled, times)
  rows <- list()
  add <- function(outcome, arm, against, estimate, draws, n) {
    ends <- interval(draws)
    # So few people that all samples that have a g have the same one: it says nothing.
    if (startsWith(outcome, "g ") && isTRUE(ends[1] == ends[2])) estimate <- ends <- c(NA, NA)
    rows[[length(rows) + 1]] <<- data.frame(outcome, arm, against, estimate = estimate[1], low = ends[1], high = ends[2], n)
  }
  for (arm in names(arms)) {
    for (name in c("pre", "post", "change", "gain", "gains", "g"))
      add(name, arm, "", found[[arm]][[name]], drawn[[arm]][[name]], nrow(arms[[arm]]))
  }
  for (arm in names(arms)[-1]) {
    first <- names(arms)[1]
    one <- betweenArms(found[[first]], found[[arm]])
    many <- betweenArms(drawn[[first]], drawn[[arm]])
    for (name in names(one)) add(paste0(name, " between arms"), arm, first, one[[name]], many[[name]], nrow(arms[[first]]) + nrow(arms[[arm]]))
  }
  do.call(rbind, rows)
}

# ---- the mixed model

# Returns the odds ratios of logit P(right) = phase * arm + person + item (D. Bates et al. 2015), with Wald intervals, and what
# lme4 says of the fit, in words.
mixedModel <- function(tests) {
  tests <- droplevels(tests)
  terms <- c(if (nlevels(tests$phase) > 1) "phase", if (nlevels(tests$arm) > 1) "arm")
  if (!("phase" %in% terms)) return(list(words = "There is only one test: nothing can be compared."))
  formula <- as.formula(paste("right ~", paste(terms, collapse = " * "), "+ (1 | participant) + (1 | itemForm)"))
  said <- character(0)
  fit <- tryCatch(withCallingHandlers(
    lme4::glmer(formula, tests, family = binomial, control = lme4::glmerControl(optimizer = "bobyqa")),
    warning = function(w) { said <<- c(said, conditionMessage(w)); invokeRestart("muffleWarning") },
    message = function(m) invokeRestart("muffleMessage")), error = function(e) conditionMessage(e))
  if (is.character(fit)) return(list(words = paste("The model could not be fitted:", fit)))
  table <- summary(fit)$coefficients
  rows <- data.frame(term = rownames(table), estimate = table[, 1], se = table[, 2], p = table[, 4], row.names = NULL)
  rows$low <- rows$estimate - qnorm(0.975) * rows$se
  rows$high <- rows$estimate + qnorm(0.975) * rows$se
  words <- if (lme4::isSingular(fit))
    "Singular fit: people or items do not differ more than chance lets them, so their spread was estimated as zero. The other numbers hold."
  said <- said[!grepl("singular", said)]
  list(rows = rows, spread = as.data.frame(lme4::VarCorr(fit))[c("grp", "sdcor")], fit = fit, words = c(words, said))
}

interactionTerm <- function(tests) {
  tests <- droplevels(tests)
  if (nlevels(tests$arm) == 2) paste0("phasepost:arm", levels(tests$arm)[2]) else NA
}

# ---- items, misconceptions, confidence

kr20 <- function(matrix) {
  k <- ncol(matrix)
  total <- rowSums(matrix)
  spread <- mean((total - mean(total))^2)
  if (k < 2 || nrow(matrix) < 3 || spread == 0) return(NA)
  p <- colMeans(matrix)
  k / (k - 1) * (1 - sum(p * (1 - p)) / spread)
}

correlation <- function(a, b) if (length(a) < 3 || sd(a) == 0 || sd(b) == 0) NA else cor(a, b)

# Returns a row for each item and form: difficulty and the correlation with the rest of its test, before and after; n counts people.
itemStatistics <- function(tests) {
  total <- ave(tests$right, tests$participant, tests$phase, FUN = sum)
  tests$rest <- total - tests$right
  rows <- lapply(split(tests, tests$itemForm), function(of) {
    share <- function(phase) if (any(of$phase == phase)) mean(of$right[of$phase == phase]) else NA
    apart <- function(phase) correlation(of$right[of$phase == phase], of$rest[of$phase == phase])
    data.frame(item = of$item[1], form = of$form[1], concept = of$concept[1], n = length(unique(of$participant)), before = share("pre"), after = share("post"),
               apartBefore = apart("pre"), apartAfter = apart("post"))
  })
  do.call(rbind, rows)
}

reliability <- function(tests) {
  rows <- lapply(split(tests, list(tests$form, tests$phase), drop = TRUE), function(of) {
    matrix <- with(of, tapply(right, list(participant, item), sum))
    matrix[is.na(matrix)] <- 0
    data.frame(form = of$form[1], phase = as.character(of$phase[1]), n = nrow(matrix), kr20 = kr20(matrix))
  })
  do.call(rbind, rows)
}

# Returns for each misconception how many people had a sure and wrong answer of it before, after, and how many changed; p of
# McNemar's exact test: of b + c people who changed, b to the better, each way equally likely.
sureAndWrong <- function(tests) {
  wrong <- tests[tests$misconception != "" & tests$right == 0 & !is.na(tests$sure) & tests$sure >= kSure, ]
  both <- intersect(tests$participant[tests$phase == "pre"], tests$participant[tests$phase == "post"])
  names <- sort(unique(tests$misconception[tests$misconception != ""]))
  rows <- lapply(names, function(name) {
    of <- function(phase) both %in% wrong$participant[wrong$misconception == name & wrong$phase == phase]
    before <- of("pre"); after <- of("post")
    lost <- sum(before & !after); got <- sum(!before & after)
    p <- if (lost + got > 0) binom.test(lost, lost + got)$p.value else 1
    data.frame(misconception = name, n = length(both), before = sum(before), after = sum(after), lost, got, p)
  })
  do.call(rbind, rows)
}

confidenceTable <- function(tests) {
  of <- tests[!is.na(tests$sure) & tests$answer != "", ]
  if (!nrow(of)) return(NULL)
  aggregate(cbind(right = of$right, n = 1) ~ sure + phase, of, sum)
}

# ---- one result

# Returns the rows of results.csv. Everything but the primary outcome is corrected by Holm's method.
resultsOf <- function(study, describeOnly) {
  tests <- study$tests
  scores <- scoresOf(tests)
  effects <- effectsOf(scores, as.integer(fact(study, "seed", "1")))
  rows <- if (is.null(effects)) NULL else cbind(effects, p = NA)
  model <- if (describeOnly) list(words = "With so few people no model is fitted.") else mixedModel(tests)
  if (!is.null(model$rows)) {
    of <- model$rows[model$rows$term != "(Intercept)", ]
    rows <- rbind(rows, data.frame(outcome = paste("odds ratio", of$term), arm = "", against = "", estimate = exp(of$estimate), low = exp(of$low),
                                   high = exp(of$high), n = length(unique(tests$participant)), p = of$p))
  }
  sure <- sureAndWrong(tests)
  if (!is.null(sure) && nrow(sure)) {
    rows <- rbind(rows, data.frame(outcome = paste("sure and wrong", sure$misconception), arm = "", against = "",
                                   estimate = sure$after - sure$before, low = NA, high = NA, n = sure$n, p = if (describeOnly) NA else sure$p))
  }
  primary <- fact(study, "primary")
  term <- if (primary == "gain between arms") interactionTerm(tests) else if (primary == "gain") "phasepost" else NA
  rows$primary <- !is.na(term) & rows$outcome == paste("odds ratio", term)
  rows$p_holm <- NA
  others <- which(!is.na(rows$p) & !rows$primary)
  rows$p_holm[others] <- p.adjust(rows$p[others], "holm")
  list(rows = rows, model = model, sure = sure, scores = scores)
}

# ---- the page

esc <- function(text) {
  text <- gsub("&", "&amp;", text, fixed = TRUE); text <- gsub("<", "&lt;", text, fixed = TRUE)
  gsub("\"", "&quot;", gsub(">", "&gt;", text, fixed = TRUE), fixed = TRUE)
}
num <- function(x, digits = 2) ifelse(is.na(x), "&ndash;", sub("^-", "&minus;", formatC(x, digits = digits, format = "f")))
pWords <- function(p) ifelse(is.na(p), "&ndash;", ifelse(p < 0.001, "&lt; 0.001", formatC(p, digits = 3, format = "f")))
between <- function(low, high, digits = 2) ifelse(is.na(low), "&ndash;", paste(num(low, digits), "to", num(high, digits)))

htmlTable <- function(head, columns) {
  cells <- do.call(paste0, lapply(columns, function(column) paste0("<td>", column, "</td>")))
  c("<table><thead><tr>", paste0("<th>", head, "</th>", collapse = ""), "</tr></thead><tbody>", paste0("<tr>", cells, "</tr>"), "</tbody></table>")
}

# Draws the means of each arm before, after and delayed, with the people as dots.
scoresPicture <- function(scores) {
  colours <- c("#1f5fa8", "#c2571a", "#2d7d46", "#7a3e9d", "#8a6d00", "#444444")
  phases <- kLevels[vapply(kLevels, function(p) any(!is.na(scores[[p]])), TRUE)]
  width <- 620; height <- 320
  x <- function(phase, arm, arms) 90 + (match(phase, phases) - 1) * 500 / max(1, length(phases)) + 60 + (arm - (arms + 1) / 2) * 26
  y <- function(value) 280 - value * 2.5
  lines <- paste0("<svg viewBox=\"0 0 ", width, " ", height, "\" width=\"", width, "\" role=\"img\" aria-label=\"Right answers of each person in each test\">")
  for (tick in seq(0, 100, 25))
    lines <- c(lines, sprintf("<line x1=\"60\" x2=\"610\" y1=\"%g\" y2=\"%g\" stroke=\"#ddd\"/><text x=\"52\" y=\"%g\" text-anchor=\"end\">%g %%</text>", y(tick), y(tick), y(tick) + 4, tick))
  arms <- levels(droplevels(scores$arm))
  for (k in seq_along(arms)) {
    of <- scores[scores$arm == arms[k], ]
    colour <- colours[(k - 1) %% length(colours) + 1]
    means <- NULL
    for (phase in phases) {
      values <- of[[phase]][!is.na(of[[phase]])]
      if (!length(values)) next
      at <- x(phase, k, length(arms))
      shift <- ((seq_along(values) * 7) %% 11 - 5) * 0.9
      lines <- c(lines, sprintf("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\" fill-opacity=\"0.25\"/>", at + shift, y(values), colour))
      means <- c(means, sprintf("%.1f,%.1f", at, y(mean(values))))
      lines <- c(lines, sprintf("<rect x=\"%.1f\" y=\"%.1f\" width=\"18\" height=\"4\" fill=\"%s\"/>", at - 9, y(mean(values)) - 2, colour))
    }
    lines <- c(lines, sprintf("<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"2\"/>", paste(means, collapse = " "), colour),
               sprintf("<rect x=\"%g\" y=\"6\" width=\"12\" height=\"12\" fill=\"%s\"/><text x=\"%g\" y=\"17\">%s</text>", 70 + (k - 1) * 150, colour, 88 + (k - 1) * 150, esc(arms[k])))
  }
  for (phase in phases)
    lines <- c(lines, sprintf("<text x=\"%.1f\" y=\"305\" text-anchor=\"middle\">%s</text>", x(phase, (length(arms) + 1) / 2, length(arms)), kPhaseWords[phase]))
  c(lines, "</svg>")
}

kStyle <- "body{font:16px/1.5 sans-serif;max-width:62em;margin:1.5em auto;padding:0 1em;color:#222;background:#fff}
h1,h2{line-height:1.2}h2{margin-top:2em;border-bottom:1px solid #ccc}
table{border-collapse:collapse;margin:.8em 0;font-size:.92em}th,td{padding:.25em .7em;border-bottom:1px solid #ddd;text-align:left}
th{background:#f1f1f1}.note{background:#fff4d6;border-left:4px solid #d69e00;padding:.5em 1em}svg text{font:13px sans-serif;fill:#333}"

effectsSection <- function(found, describeOnly) {
  rows <- found$rows
  of <- function(name) rows[rows$outcome == name, ]
  words <- c(pre = "before (%)", post = "after (%)", change = "change (points)", gain = "gain of the means &lang;g&rang;", gains = "mean of the people's gains",
             g = "Hedges' g of the change")
  out <- "<h2>Each arm</h2>"
  out <- c(out, scoresPicture(found$scores))
  table <- do.call(rbind, lapply(names(words), function(name) if (nrow(of(name))) cbind(of(name), words = words[name])))
  if (!is.null(table))
    out <- c(out, htmlTable(c("arm", "outcome", "n", "estimate", "95 % interval"), list(esc(table$arm), table$words, table$n, num(table$estimate), between(table$low, table$high))))
  full <- found$scores$participant[!is.na(found$scores$pre) & found$scores$pre == 100]
  if (length(full))
    out <- c(out, paste0("<p>", length(full), " had everything right before and have no gain of their own: ", esc(paste(full, collapse = ", ")), ".</p>"))
  table <- rows[grepl(" between arms$", rows$outcome), ]
  if (nrow(table))
    out <- c(out, "<h2>Between the arms</h2>", htmlTable(c("arm", "against", "outcome", "n", "estimate", "95 % interval"),
      list(esc(table$arm), esc(table$against), c("change between arms" = "difference of the changes (points)", "gain between arms" = "difference of &lang;g&rang;",
        "g between arms" = "Hedges' g")[table$outcome], table$n, num(table$estimate), between(table$low, table$high))))
  c(out, "<p>&lang;g&rang; = (after &minus; before) / (100 &minus; before). Intervals by ", kBootstraps, " bootstrap samples of people. Hedges' g: mean change in units of its standard deviation, corrected for small samples.</p>")
}

# Returns the names of the model's terms in words: after, in the second arm, against before in the first.
termWords <- function(terms) {
  terms <- sub("phasepost", "after, against before", sub("phasedelayed", "delayed, against before", terms))
  sub("(.*):arm(.*)", "\\1: more in \\2", sub("^arm(.*)", "\\1, before", terms))
}

modelSection <- function(found) {
  out <- "<h2>Mixed model</h2>"
  rows <- found$rows[grepl("^odds ratio", found$rows$outcome), ]
  if (nrow(rows)) {
    out <- c(out, "<p>Odds of a right answer: <code>correct ~ phase * arm + (1 | participant) + (1 | item)</code>.</p>",
      htmlTable(c("term", "odds ratio", "95 % interval", "p", "p after Holm"), list(paste0(esc(termWords(sub("^odds ratio ", "", rows$outcome))), ifelse(rows$primary, " <b>(primary)</b>", "")),
        num(rows$estimate), between(rows$low, rows$high), pWords(rows$p), ifelse(rows$primary, "not corrected", pWords(rows$p_holm)))))
    spread <- found$model$spread
    out <- c(out, paste0("<p>Standard deviations in log odds: ", paste(ifelse(spread$grp == "participant", "people", "items"), num(spread$sdcor), collapse = ", "), ".</p>"))
  }
  c(out, if (length(found$model$words)) paste0("<p class=\"note\">", esc(found$model$words), "</p>"))
}

# Returns whose items these are, and what is known of them. The fact is missing in exports of older programs.
bankWords <- function(study) switch(fact(study, "bank"),
  shipped = "The items of the shipped bank are <b>unvalidated</b>: these numbers describe answers to them, not understanding.",
  own = "The items are of the study's own bank: whether they are validated is not known here.",
  "If the items are those of the shipped bank, they are <b>unvalidated</b>: these numbers describe answers to them, not understanding.")

itemsSection <- function(study) {
  tests <- study$tests
  items <- itemStatistics(tests)
  alpha <- reliability(tests)
  c("<h2>Items</h2>", "<p>", bankWords(study), " Difficulty is the share of right answers; discrimination is the point-biserial correlation with the rest of the same test.</p>",
    htmlTable(c("item", "form", "concept", "people", "right before", "right after", "discrimination before", "discrimination after"),
      list(esc(items$item), esc(items$form), esc(items$concept), items$n, num(items$before), num(items$after), num(items$apartBefore), num(items$apartAfter))),
    "<p>Reliability (KR-20, which is &alpha; of right and wrong):</p>",
    htmlTable(c("form", "test", "people", "KR-20"), list(esc(alpha$form), kPhaseWords[alpha$phase], alpha$n, num(alpha$kr20))))
}

sureSection <- function(found) {
  sure <- found$sure
  if (is.null(sure) || !nrow(sure)) return(NULL)
  rows <- found$rows[match(paste("sure and wrong", sure$misconception), found$rows$outcome), ]
  c("<h2>Sure and wrong</h2>", "<p>People with a sure and wrong answer (&ldquo;fairly sure&rdquo; or &ldquo;certain&rdquo;) of each misconception, before and after. McNemar's exact test.</p>",
    htmlTable(c("misconception", "people", "before", "after", "lost it", "got it", "p", "p after Holm"),
      list(esc(sure$misconception), sure$n, sure$before, sure$after, sure$lost, sure$got, pWords(rows$p), pWords(rows$p_holm))))
}

confidenceSection <- function(tests) {
  table <- confidenceTable(tests)
  if (is.null(table)) return(NULL)
  words <- c("guess", "unsure", "fairly sure", "certain")
  c("<h2>Confidence and correctness</h2>", htmlTable(c("test", "how sure", "answers", "right"),
    list(kPhaseWords[as.character(table$phase)], words[table$sure], table$n, paste(num(100 * table$right / table$n, 0), "%"))))
}

ratingsSection <- function(ratings) {
  if (!nrow(ratings)) return(NULL)
  ratings$value <- suppressWarnings(as.numeric(ratings$answer))
  ratings <- ratings[!is.na(ratings$value), ]
  if (!nrow(ratings)) return(NULL)
  rows <- do.call(rbind, lapply(split(ratings, list(ratings$item, ratings$arm), drop = TRUE), function(of)
    data.frame(item = of$item[1], arm = of$arm[1], n = nrow(of), mean = mean(of$value), most = max(of$value))))
  c("<h2>Ratings</h2>", "<p>0 to 10.</p>", htmlTable(c("question", "arm", "n", "mean", "largest"), list(esc(rows$item), esc(rows$arm), rows$n, num(rows$mean, 1), rows$most)))
}

peopleSection <- function(study) {
  people <- study$people
  out <- "<h2>People</h2>"
  arms <- unique(people$arm)
  counts <- vapply(arms, function(arm) sum(people$arm == arm & people$excluded == ""), 1L)
  out <- c(out, htmlTable(c("arm", "people in the analysis"), list(esc(arms), counts)))
  left <- people[people$excluded != "", ]
  words <- c(stopped = "stopped", unfinished = "had not finished")
  for (rule in unique(left$excluded)) {
    of <- left$participant[left$excluded == rule]
    out <- c(out, paste0("<p>Left out by rule: ", length(of), " ", esc(if (rule %in% names(words)) words[rule] else rule), ": ", esc(paste(of, collapse = ", ")), ".</p>"))
  }
  if (length(study$unexplained)) out <- c(out, paste0("<p>", length(study$unexplained), " of those in the analysis had a lesson that did not explain itself: ", esc(paste(study$unexplained, collapse = ", ")), ".</p>"))
  withdrew <- suppressWarnings(as.integer(fact(study, "withdrew", "0")))
  if (!is.na(withdrew) && withdrew > 0) out <- c(out, paste0("<p>", withdrew, " withdrew: their data were deleted.</p>"))
  out
}

pageOf <- function(study, found, describeOnly) {
  title <- esc(fact(study, "title", "Study"))
  primary <- fact(study, "primary")
  isTested <- any(found$rows$primary)
  c("<!DOCTYPE html>", paste0("<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\"><title>", title, "</title><style>", kStyle, "</style></head><body>"),
    if (describeOnly) paste0("<p class=\"note\"><b>Description only:</b> fewer than ", kFewest, " people in an arm. No p-values; ask people why they answered as they did.</p>"),
    paste0("<h1>", title, "</h1>"),
    paste0("<p class=\"note\">", bankWords(study), "</p>"),
    if (primary != "") paste0("<p>Primary outcome, fixed before the first participant: <b>", esc(primary), "</b>. It is not corrected; all others are, by Holm's method.",
      if (!isTested && !describeOnly) " This program has no test of its own for it: everything here is corrected." else "", "</p>"),
    if (fact(study, "sha256") != "") paste0("<p>SHA-256 of study and items: <code>", esc(fact(study, "sha256")), "</code></p>"),
    if (fact(study, "sha256_before") != "") paste0("<p class=\"note\">The study was amended after its first participant: before, it was <code>", esc(fact(study, "sha256_before")), "</code>.</p>"),
    peopleSection(study), effectsSection(found, describeOnly), modelSection(found), sureSection(found), confidenceSection(study$tests), itemsSection(study), ratingsSection(study$ratings),
    paste0("<p>R ", R.version$major, ".", R.version$minor, ", lme4 ", as.character(packageVersion("lme4")), ".</p>"), "</body></html>")
}

# Writes a file whole or not at all.
writeWhole <- function(lines, folder, name) {
  part <- file.path(folder, paste0(".", name, ".part"))
  connection <- file(part, "wb")
  writeLines(enc2utf8(lines), connection, useBytes = TRUE)
  close(connection)
  if (!file.rename(part, file.path(folder, name))) stop(sprintf("%s cannot be written", name), call. = FALSE)
}

csvOf <- function(rows) {
  quoted <- function(text) ifelse(grepl("[\",\r\n]", text), paste0("\"", gsub("\"", "\"\"", text), "\""), text)
  value <- function(x) ifelse(is.na(x), "", formatC(as.numeric(x), digits = 10, format = "g"))
  c("outcome,arm,against,estimate,low,high,p,p_holm,primary,n",
    paste(quoted(rows$outcome), quoted(rows$arm), quoted(rows$against), value(rows$estimate), value(rows$low), value(rows$high), value(rows$p),
          value(rows$p_holm), ifelse(rows$primary, 1, 0), rows$n, sep = ","))
}

analyse <- function(folder) {
  study <- readStudy(folder)
  if (!nrow(study$tests)) stop("responses.csv has no answer of a test, expected some before and after", call. = FALSE)
  scores <- scoresOf(study$tests)
  inBoth <- scores[!is.na(scores$pre) & !is.na(scores$post), ]
  describeOnly <- min(table(factor(inBoth$arm, levels(study$tests$arm)))) < kFewest
  found <- resultsOf(study, describeOnly)
  writeWhole(csvOf(found$rows), folder, "results.csv")
  writeWhole(pageOf(study, found, describeOnly), folder, "report.html")
  invisible(found)
}

if (sys.nframe() == 0L) {
  folder <- commandArgs(TRUE)
  if (length(folder) != 1) stop("expected one folder", call. = FALSE)
  tryCatch(analyse(folder), error = function(e) { cat("error: ", folder, ": ", conditionMessage(e), "\n", sep = "", file = stderr()); quit(status = 1) })
}
