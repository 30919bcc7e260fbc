"use strict";
// The page of a phone and of the teacher. What the class says is put into the page as text, never as HTML.
const T = {{texts}};
const isTeacher = location.pathname === "/teacher";
const part = id => document.getElementById(id);
const kept = "carom-class-token";
const store = (name, value) => { try { localStorage.setItem(name, value); } catch (e) { /* as a visitor without memory */ } };
const stored = name => { try { return localStorage.getItem(name) || ""; } catch (e) { return ""; } };
let token = stored(kept), pin = "", wasIn = false, socket = null, state = null, shown = "", last = null, wait = 0, timer = 0, alive = 0;

const fill = (words, ...values) => words.replace(/\{\}/g, () => values.shift());
const say = (id, words) => { const at = part(id); if (at.textContent !== words) at.textContent = words; };
const send = message => { if (socket && socket.readyState === 1) socket.send(JSON.stringify(message)); };
const make = (kind, words, name) => {
  const made = document.createElement(kind);
  if (words) made.textContent = words;
  if (name) made.className = name;
  return made;
};

// Joins, and joins again whenever the network was away.
function join() {
  clearTimeout(timer);
  if (isTeacher && !pin) return;
  if (socket) { socket.onclose = socket.onmessage = null; socket.close(); }
  say("link", T.connecting);
  socket = new WebSocket("ws://" + location.host + "/socket");
  socket.onopen = greet;
  socket.onmessage = heard;
  socket.onclose = () => {
    say("link", T.away);
    wait = Math.min(1500, wait + 300 + 300 * Math.random());
    timer = setTimeout(join, wait);
  };
}

function greet() {
  wait = 0;
  send(isTeacher ? { pin: pin } : { hello: token });
}

// Asks whether the class is still there, after sleep or another network. A PIN is sent once: it takes the lead.
function wake() {
  if (document.hidden || (isTeacher && !pin)) return;
  if (!socket || socket.readyState !== 1) return join();
  const before = alive;
  send({ hello: token });
  setTimeout(() => { if (alive === before) join(); }, 2000);
}

function heard(event) {
  alive += 1;
  const told = JSON.parse(event.data);
  say("refused", told.refused || "");
  if (!told.state) {
    if (isTeacher && told.refused) askPin(wasIn ? T.newPin : told.refused);
    return;
  }
  say("link", T.joined);
  wasIn = isTeacher;
  state = told;
  if (told.word) say("word", told.word);
  if (told.token) { token = told.token; if (!isTeacher) store(kept, token); }
  draw();
  answerAgain();
}

// Asks the teacher for the PIN, and says why.
function askPin(why) {
  pin = "";
  wasIn = false;
  say("refused", why);
  say("link", "");
  part("enter").hidden = false;
  part("steps").hidden = part("now").hidden = true;
  socket.onclose = null;
  socket.close();
  part("pin").focus();
}

// A vote that was open when the class's computer broke off is open again: what was answered is answered again.
function answerAgain() {
  if (state.state !== "vote") last = null;
  if (!last || state.yours || isTeacher) return;
  if (last.question === state.question && last.round === state.round) last.messages.forEach(send);
}

function radios(into, name, words) {
  part(into).replaceChildren(...words.map((text, index) => {
    const label = make("label", "", "choice"), input = make("input");
    input.type = "radio";
    input.name = name;
    input.value = index + 1;
    label.append(input, make("span", text));
    return label;
  }));
}
const chosen = name => { const at = document.querySelector(`input[name=${name}]:checked`); return at ? +at.value : 0; };
const choose = (name, value) => {
  const at = document.querySelector(`input[name=${name}][value="${value}"]`);
  if (at) at.checked = true;
};

function drawVote() {
  const open = state.state === "vote" && !isTeacher;
  const now = open ? [state.lesson, state.question, state.round].join("\n") : "";
  part("vote").hidden = !open;
  if (now === shown) return;
  shown = now;
  if (!open) return;
  radios("answers", "answer", state.answers);
  radios("sure", "sure", T.confidence);
  part("reason").value = "";
  if (state.yours) choose("answer", state.yours);
  if (state.yours) choose("sure", state.confidence);
}

function drawBars() {
  const counts = state.counts || [];
  part("bars").replaceChildren(...(counts.length ? state.answers : []).map((answer, index) => {
    const right = state.right === index + 1;
    const outcome = make("div", "", right ? "outcome right" : "outcome");
    const words = make("p", answer);
    if (right) words.append(" ", make("span", T.right, "mark"));
    outcome.append(words);
    counts.forEach((vote, round) => {
      if (!vote.length) return;
      const all = vote.reduce((sum, n) => sum + n, 0) || 1, row = make("div", "", round ? "row second" : "row");
      const track = make("div", "", "track"), bar = make("div", "", "bar");
      bar.style.width = 100 * vote[index] / all + "%";
      track.append(bar);
      row.append(make("span", fill(T.bar, round + 1, vote[index]), "number"), track);
      outcome.append(row);
    });
    return outcome;
  }));
}

function drawTeacher() {
  part("steps").hidden = !isTeacher;
  if (!isTeacher) return;
  if (state.teacher === false) return askPin(T.taken);
  part("enter").hidden = true;
  say("hint", state.hint || "");
  const onwards = { idle: "ask", vote: "close", closed: state.round < 2 ? "discuss" : "show", discuss: "again", shown: "explain",
    explained: "next" }[state.state];
  for (const button of part("buttons").children) {
    button.disabled = !(state.steps || []).includes(button.value);
    button.className = button.value === onwards ? "" : "other";
  }
  const reasons = state.reasons || [];
  part("heard").hidden = !reasons.length;
  part("reasons").replaceChildren(...reasons.map(words => make("li", words)));
}

function draw() {
  part("now").hidden = false;
  const vote = state.state === "vote", closed = state.state === "closed";
  say("lesson", state.lesson);
  say("phase", isTeacher && state.state === "idle" ? "" : vote || closed ? fill(vote ? T.vote : T.closed, state.round) : T[state.state]);
  say("count", state.round ? fill(T.count, state.answered, state.phones) : fill(T.phones, state.phones));
  say("question", state.state === "idle" ? "" : state.question);
  drawVote();
  const yours = state.yours ? state.answers[state.yours - 1] : "";
  const told = !isTeacher && state.state !== "idle";
  say("first", told && state.first ? fill(T.first, state.answers[state.first - 1]) : "");
  say("said", told && yours ? fill(vote ? T.counted : T.yours, yours) : "");
  drawBars();
  drawTeacher();
}

part("vote").addEventListener("submit", event => {
  event.preventDefault();
  const answer = chosen("answer"), sure = chosen("sure"), words = part("reason").value.trim();
  if (!answer) return say("refused", T.chooseFirst);
  const message = { answer: answer, round: state.round };
  if (sure) message.confidence = sure;
  last = { question: state.question, round: state.round, messages: [message] };
  if (words) last.messages.push({ reason: words, round: state.round });
  last.messages.forEach(send);
});
part("enter").addEventListener("submit", event => {
  event.preventDefault();
  pin = part("pin").value.trim();
  part("pin").value = "";
  join();
});
for (const [step, words] of Object.entries(T.steps)) {
  const button = make("button", words);
  button.type = "button";
  button.value = step;
  button.addEventListener("click", () => send({ do: step }));
  part("buttons").append(button);
}
for (const event of ["online", "pageshow", "focus"]) addEventListener(event, wake);
document.addEventListener("visibilitychange", wake);
setInterval(wake, 5000);
if (isTeacher) { part("enter").hidden = false; say("link", ""); part("pin").focus(); }
else join();
